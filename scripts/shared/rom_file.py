"""A reader of reduced presses by their description alone (docs/rom-file.md), with no library."""

import struct
from array import array

KIND = b"deadpoint reduced press 3\n"
CERTIFICATE_KIND = b"deadpoint certificate 2\n"
FIELDS_KIND = b"deadpoint fields of a reduced press 1\n"


class Reader:
    def __init__(self, data):
        self.data, self.at = data, 0

    def raw(self, count):
        piece = self.data[self.at:self.at + count]
        if len(piece) != count:
            raise ValueError("the file is cut short")
        self.at += count
        return piece

    def number(self, code):
        return struct.unpack("<" + code, self.raw(struct.calcsize("<" + code)))[0]

    u8 = bool = lambda self: self.number("B")
    u32 = lambda self: self.number("I")
    i32 = lambda self: self.number("i")
    u64 = lambda self: self.number("Q")
    f64 = lambda self: self.number("d")
    vec2 = lambda self: [self.f64() for _ in range(2)]
    vec3 = lambda self: [self.f64() for _ in range(3)]
    text = lambda self: self.raw(self.u64()).decode()

    def list(self, read):
        return [read() for _ in range(self.u64())]

    def numbers(self, code):
        values = array(code)
        values.frombytes(self.raw(self.u64() * values.itemsize))
        return values

    def optional(self, read):
        return read() if self.bool() else None

    def fields(self, **kinds):
        return {name: getattr(self, kind)() if isinstance(kind, str) else kind() for name, kind in kinds.items()}

    def matrix(self):
        rows, columns, entries = self.u64(), self.u64(), self.numbers("f")
        if len(entries) != rows * columns:
            raise ValueError("a matrix has another number of entries than it says")
        return {"rows": rows, "columns": columns, "entries": entries}


def fnv1a(data):
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return value


def read_machine(r):
    def part():
        return r.fields(name="text", body="text", first_cell="u32", cell_count="u32", kind="u8", volume="f64",
                        mass="f64", cut="bool", exterior_area="f64", exposed_area="f64", pieces="u32",
                        min_quality="f64", mean_quality="f64", moment_volume="f64", first="vec2", second="f64")

    def length():
        return r.optional(r.f64)

    def surface():
        return r.fields(name="text", area="f64", height=length, cylinder_diameter=length, disk_diameter=length,
                        area_over_perimeter=length, mean="vec2", mean_square="f64",
                        shares=lambda: r.list(lambda: r.fields(part="u32", area="f64")))

    def geometry():
        kind = r.u8()
        forms = [{}, {"normal": "vec3", "offset": "f64"},
                 {"point": "vec3", "axis": "vec3", "radius": "f64", "bore": "bool"}]
        return r.fields(**forms[kind])

    def contact():
        return r.fields(name="text", geometry=geometry, area="f64", drawn_area="f64", least_area="f64", stroke="f64",
                        area_a="f64", area_b="f64", max_gap="f64", part_a="u32", part_b="u32")

    def overlap():
        return r.fields(part_a="text", part_b="text", where="vec3", depth="f64")

    return r.fields(parts=lambda: r.list(part), surfaces=lambda: r.list(surface), interfaces=lambda: r.list(contact),
                    bonds=lambda: r.list(contact), overlaps=lambda: r.list(overlap),
                    floating_parts=lambda: r.list(r.text), dropped_parts=lambda: r.list(r.text), half_model="bool")


def read_chain(r):
    return r.fields(bearings="i32", travel_by_play="f64", pressed_along_stroke="f64",
                    corners=lambda: r.list(lambda: r.fields(name="text", x="f64", z="f64")),
                    clearances=lambda: r.list(lambda: r.fields(name="text", kind="i32", joint="text")),
                    left_out=lambda: r.list(r.text), mirrored="bool", first_gap="u64")


def read_frame(r):
    return r.fields(rods=lambda: r.list(lambda: r.fields(part="text", preload="text", start="f64", held_share="f64")),
                    bonds=lambda: r.list(lambda: r.fields(name="text", preload="text", area="f64", start="f64")),
                    support_force=lambda: r.optional(r.f64))


def opened(path, kind):
    with open(path, "rb") as file:
        r = Reader(file.read())
    if r.raw(len(kind)) != kind:
        raise ValueError("this is another kind of file")
    return r


def check_end(r, checksum):
    if r.u64() != len(r.data) or (checksum and r.u64() != fnv1a(r.data[:-8])):
        raise ValueError("the file was cut short or changed")


def read_rom(path, checksum=True):
    r = opened(path, KIND)
    rom = r.fields(version="text", name="text", case_hash="text", fixed_part="text", large_file="text",
                   machine=lambda: read_machine(r), size_scale="f64", cells="u64", unknowns="u64", adjoints="u64", reference="f64",
                   chain=lambda: r.optional(lambda: read_chain(r)), frame=lambda: r.optional(lambda: read_frame(r)),
                   first_frame="u64",
                   box=lambda: r.list(lambda: r.fields(name="text", kind="i32", members=lambda: r.list(r.u64),
                                                       base=lambda: r.list(r.f64), least="f64", most="f64")),
                   errors=lambda: r.list(lambda: r.fields(of="text", temperature="f64", gap="f64")),
                   sizes=lambda: r.list(lambda: r.fields(states="u64", temperature="f64", gap="f64")),
                   interfaces="u64", parts="u64", surfaces="u64", bodies="u64", probes="u64",
                   interface_names=lambda: r.list(r.text), interface_area=lambda: r.numbers("d"),
                   surface_area=lambda: r.numbers("d"), solid=lambda: r.numbers("d"),
                   joint_terms=lambda: r.list(r.matrix), films=lambda: r.list(r.matrix), functionals="matrix",
                   observed="matrix", part_states="matrix")
    check_end(r, checksum)
    return rom


def read_fields(path, checksum=True):
    """The fields of the states: a list of numbers for each state."""
    r = opened(path, FIELDS_KIND)
    found = r.fields(version="text", model="text", mesh="text", fields=lambda: r.list(lambda: r.numbers("f")))
    check_end(r, checksum)
    return found


def check_fields(path, rom):
    found = read_fields(path)
    sizes = {len(field) for field in found["fields"]}
    if len(found["fields"]) != rom["part_states"]["rows"] or sizes != {rom["unknowns"]}:
        raise ValueError("fields differ in number or size from states and unknowns")
    if int(found["model"], 16) != fnv1a(rom["functionals"]["entries"].tobytes()):
        raise ValueError("the fields belong to another model")


def check_certificate(path, rom):
    """Reads a certificate of the large model, and checks that its numbers fit each other and the model."""
    r = opened(path, CERTIFICATE_KIND)
    found = r.fields(version="text", model="text", states="u64", functionals="u64", observed="u64",
                     first=lambda: r.list(r.u64), factors=r.matrix, lowest=lambda: r.list(r.f64),
                     highest=lambda: r.list(r.f64), remainder=r.matrix, root=lambda: r.numbers("f"), products=r.matrix)
    check_end(r, checksum=False)  # of some 20 MB, which takes Python a quarter of a minute
    vectors = found["states"] + found["factors"]["columns"] + found["functionals"] + found["observed"]
    terms = len(rom["joint_terms"]) + len(rom["films"]) + 1
    if (len(found["root"]) != vectors * (vectors + 1) // 2 or {len(found[k]) for k in ("lowest", "highest")} != {terms}
            or len(found["first"]) != terms + 1 or found["first"][-1] != found["factors"]["columns"]):
        raise ValueError("a certificate has another number of values than vectors or terms")
    if int(found["model"], 16) != fnv1a(rom["functionals"]["entries"].tobytes()):
        raise ValueError("the certificate belongs to another model")


def main(path, fields=None, certificate=None):
    rom = read_rom(path)
    if fields:
        check_fields(fields, rom)
    if certificate:
        check_certificate(certificate, rom)
    states = rom["part_states"]["rows"]
    for factor in rom["joint_terms"] + rom["films"]:
        if factor["rows"] not in (0, states):
            raise ValueError("a factor has another number of rows than there are states")
    if len(rom["solid"]) not in (states, states * (states + 1) // 2) or rom["functionals"]["rows"] != states:
        raise ValueError("matrices differ in size")
    print(f"{rom['name']}: {states} states, {len(rom['box'])} free coefficients, {len(rom['interface_names'])} interfaces")


if __name__ == "__main__":
    import sys
    main(*sys.argv[1:])
