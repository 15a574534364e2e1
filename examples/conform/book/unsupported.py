class Unsupported(Exception):
    """What the book does not have, or what its form is not known here."""
