"""The screen: results, facts and inputs in words and tables."""
