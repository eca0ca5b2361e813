"""What `textbook` shows, as sections: a module for each subject."""
