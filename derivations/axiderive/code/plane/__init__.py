"""The plane problem: bodies and interface of strips on the elastic half plane."""
