"""Machine files of real engines and drives, with where each number is from; `docs/examples.md` says what they show."""
