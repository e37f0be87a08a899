"""Every entry against the oracle, against enclosures and against its siblings."""
