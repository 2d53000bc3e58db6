"""What holds for all tests: laws are tried on the same examples everywhere and every time."""

from hypothesis import settings

settings.register_profile("dhlab", deadline=None, derandomize=True)
settings.load_profile("dhlab")
