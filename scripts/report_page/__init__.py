"""The parts of scripts/report."""


class Failure(Exception):
    """What the user is told, one line."""
