"""What holds for all tests: laws are tried on the same examples everywhere and every time."""

from collections import Counter, defaultdict
from statistics import median

from hypothesis import settings

settings.register_profile("dhlab", deadline=None, derandomize=True)
settings.load_profile("dhlab")


def pytest_terminal_summary(terminalreporter):
    """Show what tests have counted of judgements: ``record_property("tally", ...)``."""
    reports = (r for group in terminalreporter.stats.values() for r in group)
    told = {  # a report per phase of a test holds the same
        report.nodeid: tally
        for report in reports
        for key, tally in getattr(report, "user_properties", ())
        if key == "tally"
    }
    counts, seconds = defaultdict(Counter), defaultdict(list)
    for nodeid, tally in told.items():
        test = nodeid.split("::")[-1].split("[")[0]
        counts[test].update(tally["counts"])
        seconds[test] += tally["seconds"]
    if counts:
        terminalreporter.section("judgements")
    for test in sorted(test for test in counts if seconds[test]):  # one that failed may have none
        terminalreporter.write_line(f"{test}: {sentence(counts[test], seconds[test])}")


def sentence(c, seconds):
    """What was counted, to read."""
    parts = []
    if c["wrong answers"]:
        share = 100 * c["named"] / c["wrong answers"]
        parts += [f"{c['wrong answers']} wrong answers, mistake named in {share:.1f} %"]
        parts += [f"falsely in {c['falsely']}"]
    if c["right answers"]:
        parts += [f"{c['right answers']} right answers, called wrong {c['called wrong']}"]
    typical, most = 1000 * median(seconds), 1000 * max(seconds)
    return ", ".join([*parts, f"{typical:.0f} ms of processor each, at most {most:.0f} ms"])
