"""The definitions in numbers: they share nothing with the derivations, and judge them."""
