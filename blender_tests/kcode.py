"""A Kniterate file and a knitout file knit side by side, counting loops; of this test alone, sharing
nothing with the library."""

BESIDE = 15  # columns left and right of the bed
CAMS_TO_BACK, CAMS_TO_FRONT = ("Tr-Rr", "Tr-Rl"), ("Rr-Tr", "Rl-Tr")


def needles_of(line):
    """The needles at work in a FRNT or REAR line."""
    columns = [c for c in line.split(":")[1] if c in "._-"]
    return [i - BESIDE + 1 for i, c in enumerate(columns) if c == "-"]


def kcode_passes(text):
    """(direction, cams, carrier, racking, front needles, rear needles) of every pass."""
    passes, racking = [], 0
    lines = text.splitlines()
    assert lines[0] == "HOME"
    for number, line in enumerate(lines):
        if line.startswith("RACK:"):
            racking = float(line[5:])
        elif line.startswith((">>", "<<")):
            direction, cams, carrier, _, _ = line.split()
            front, rear = needles_of(lines[number - 4]), needles_of(lines[number - 2])
            passes.append((direction, cams, int(carrier), racking, front, rear))
    return passes


class Beds:
    """How many loops each needle holds, and every loop made: (carrier, needle, loops below)."""

    def __init__(self):
        self.held, self.made = {}, []

    def work(self, needle, carrier, tucks):
        below = self.held.get(needle, 0)
        if carrier:
            self.made.append((carrier, needle, below))
            self.held[needle] = below + 1 if tucks else 1
        elif not tucks:
            self.held[needle] = 0

    def move(self, needle, target):
        self.held[target] = self.held.get(target, 0) + self.held.pop(needle)

    def count(self):
        return {needle: loops for needle, loops in self.held.items() if loops}


def knit_kcode_pass(beds, kcode_pass):
    direction, cams, carrier, _, front, rear = kcode_pass
    if cams in CAMS_TO_BACK + CAMS_TO_FRONT:
        for f, b in zip(front, rear):
            pair = (("f", f), ("b", b))
            beds.move(*(pair if cams in CAMS_TO_BACK else reversed(pair)))
        return
    halves = dict(zip("fb", cams.split("-")))
    work = [(n, "f") for n in front] + [(n, "b") for n in rear]
    for n, bed in sorted(work, reverse=direction == "<<"):
        beds.work((bed, n), str(carrier) if carrier else None, halves[bed] == "Tu")


def knitout_steps(text):
    """A function of beds for every operation of a knitout file that changes loops."""
    for line in text.splitlines():
        words = line.split(";")[0].split()
        needles = [(w[0], int(w[1:])) for w in words if w[0] in "fb" and w[1:].isdigit()]
        if words and words[0] in ("knit", "tuck"):
            yield lambda b, n=needles[0], w=words: b.work(n, w[3], w[0] == "tuck")
        elif words and words[0] == "xfer":
            yield lambda b, n=needles: b.move(*n)
        elif words and words[0] == "drop":
            yield lambda b, n=needles[0]: b.work(n, None, False)


def knit_side_by_side(kcode, knitout):
    """Knits both and compares the beds after every pass that makes loops. -> how many loops."""
    ours, theirs = Beds(), Beds()
    steps = knitout_steps(knitout)
    last = None
    for kcode_pass in kcode_passes(kcode):
        assert kcode_pass[0] != last, "the carriage goes the same way twice"
        last = kcode_pass[0]
        before = len(ours.made)
        knit_kcode_pass(ours, kcode_pass)
        if len(ours.made) == before:
            continue
        while len(theirs.made) < len(ours.made):
            next(steps)(theirs)
        assert theirs.made[before:] == ours.made[before:]
        assert theirs.count() == ours.count()
    for step in steps:
        step(theirs)
    assert theirs.made == ours.made and theirs.count() == ours.count() == {}
    return len(ours.made)
