"""Shafts, banks, places, frames and bodies of a machine as SI arrays; behind them nothing knows specs or units."""
