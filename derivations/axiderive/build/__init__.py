"""From profiles to the bytes of the catalogue."""
