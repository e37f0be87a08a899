"""The web edition: one static page per profile, from the same page models as the printed book."""

from .site import html_sources

__all__ = ["html_sources"]
