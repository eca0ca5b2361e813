"""What a shell completes: commands, options, examples, kinds, results and paths, without what computes."""
