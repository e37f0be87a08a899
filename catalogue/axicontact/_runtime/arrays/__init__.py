"""What runs over arrays: in blocks that stay in cache, and with numbers without a range where doubles end."""
