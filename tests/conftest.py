"""What holds for all tests: laws are tried on the same examples everywhere and every time."""

from hypothesis import settings

settings.register_profile("dhlab", deadline=None, derandomize=True)
settings.load_profile("dhlab")


def pytest_terminal_summary(terminalreporter):
    """Show what tests have counted: ``record_property("tally", ...)``."""
    reports = [r for group in terminalreporter.stats.values() for r in group]
    told = {(r.nodeid, *p) for r in reports for p in getattr(r, "user_properties", ())}
    lines = [
        f"{name.split('::')[-1]}: {text}" for name, key, text in sorted(told) if key == "tally"
    ]
    if lines:
        terminalreporter.section("tallies")
        terminalreporter.write_line("\n".join(lines))
