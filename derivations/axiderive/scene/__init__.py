"""Scenes: one self-contained module with what is asked for and nothing else."""
