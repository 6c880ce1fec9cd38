"""A number as a person types it, key by key."""


class TypedNumber:
    def __init__(self):
        self.text = ""

    def take(self, character):
        """A digit, a point, a backspace, or a minus, which turns the sign; others are left out."""
        if character == "-":
            self.text = self.text[1:] if self.text.startswith("-") else "-" + self.text
        elif character == "\b":
            self.text = self.text[:-1]
        elif character == "." and "." not in self.text or character.isdigit():
            self.text += character

    @property
    def value(self):
        """None while it is no number."""
        try:
            return float(self.text)
        except ValueError:
            return None
