"""Questions that a machine answers: a folder for each."""
