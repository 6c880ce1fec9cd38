"""The part of .ply that meshes use: vertex positions and faces, text or binary."""

import numpy as np

TYPES = {
    "char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2",
    "ushort": "u2", "uint16": "u2", "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4",
    "float": "f4", "float32": "f4", "double": "f8", "float64": "f8",
}  # fmt: skip
ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}


def read_ply(data):
    """-> (vertices, polygons). Throws ValueError, IndexError, KeyError or OverflowError for what it
    does not understand."""
    end = data.find(b"end_header")
    if not data.startswith(b"ply") or end < 0:
        raise ValueError("the header is missing")
    body = data[data.index(b"\n", end) + 1 :]
    form, elements = _parse_header(data[:end].decode("ascii", "replace"))
    source = _Text(body) if form == "ascii" else _Binary(body, ORDERS[form])
    vertices, polygons = None, []
    for name, count, properties in elements:
        if not properties:
            raise ValueError(f"its element {name} has no properties")
        rows = [[source.take(p) for p in properties] for _ in range(count)]
        if name == "vertex":
            x, y, z = (_column(properties, (axis,), is_list=False) for axis in "xyz")
            vertices = np.array([[row[x], row[y], row[z]] for row in rows], dtype=np.float64)
        elif name == "face":
            at = _column(properties, ("vertex_indices", "vertex_index"), is_list=True)
            polygons = [[int(i) for i in row[at]] for row in rows]
    if vertices is None:
        raise ValueError("it has no vertices")
    return vertices, polygons


def _column(properties, names, is_list):
    """Where the property is that has one of these names."""
    for index, words in enumerate(properties):
        if words[-1] in names and (words[0] == "list") == is_list:
            return index
    raise ValueError(f"it has no {'list' if is_list else 'number'} {names[0]}")


def _parse_header(text):
    form, elements = None, []
    for line in text.splitlines()[1:]:
        words = line.split()
        if not words or words[0] in ("comment", "obj_info"):
            continue
        if words[0] == "format":
            form = words[1]
        elif words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append(tuple(words[1:]))
    if form not in ORDERS:
        raise ValueError(f"unknown format {form}")
    return form, elements


class _Text:
    def __init__(self, body):
        self.words = iter(body.split())

    def take(self, kind):
        try:
            if kind[0] != "list":
                return float(next(self.words))
            return [float(next(self.words)) for _ in range(int(next(self.words)))]
        except StopIteration:
            raise ValueError("it is cut short") from None


class _Binary:
    def __init__(self, body, order):
        self.body, self.order, self.at = body, order, 0

    def take(self, kind):
        if kind[0] != "list":
            return self._numbers(kind[0], 1)[0]
        count = int(self._numbers(kind[1], 1)[0])
        if count < 0:
            raise ValueError("it has a list of less than no entries")
        return self._numbers(kind[2], count)

    def _numbers(self, name, count):
        numbers = np.frombuffer(self.body, self.order + TYPES[name], count, self.at)
        self.at += numbers.nbytes
        return numbers
