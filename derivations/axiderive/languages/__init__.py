"""The programs of the package in other languages."""
