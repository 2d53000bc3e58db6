"""The laws are tried on the same cases in every run."""

from hypothesis import settings

settings.register_profile("laws", derandomize=True, deadline=None, max_examples=60)
settings.load_profile("laws")
