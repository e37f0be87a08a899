"""What is kept: the cache, records of entries and profiles, the index; and the one writer of files."""
