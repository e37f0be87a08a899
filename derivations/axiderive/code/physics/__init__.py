"""The contacts on the normal one, prescribed pressures, and the elastic constants."""
