"""Contact problems as entries: normal contact, compact and complete."""
