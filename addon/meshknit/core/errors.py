"""The one error of our own that callers must tell apart."""


class UsageError(Exception):
    """Wrong options or an unreadable file. The text is one sentence for people."""
