"""The track of ISO 3888-1, a double lane change: lengths, widths for a vehicle of width b, offset."""
import numpy

SECTIONS = [  # length [m], width over b, constant of the width [m], right edge [m]; None: free
    (15.0, 1.1, 0.25, 0.0),
    (30.0, None, None, None),
    (25.0, 1.2, 0.25, 3.5),
    (25.0, None, None, None),
    (15.0, 1.3, 0.25, 0.0),
    (15.0, 1.3, 0.25, 0.0),
]
LENGTH = sum(s[0] for s in SECTIONS)
MIDDLE = 15.0 + 30.0 + 12.5  # of the third section
NOTE = ("Track: ISO 3888-1 for a vehicle {width:.3g} m wide; its first lane is about the path at the start, its "
        "third section at the largest offset (of the first run). The axes have different scales.")


def width_of(vehicle, width):
    """Of the vehicle [m]: as given, else over its tyres."""
    if width:
        return width
    y = [w["point"][1] for w in vehicle.wheels]
    return float(max(y) - min(y)) + 0.3


def double_lane_change(vehicle, width):
    """[(label, x, y)] of the edges of the lanes when the path goes out and comes back, else []."""
    x, y = vehicle.get("x"), vehicle.get("y")
    if x is None:
        return []
    off = y - y[0]
    side = numpy.sign(off[int(numpy.argmax(numpy.abs(off)))])
    most = float(numpy.max(numpy.abs(off)))
    if most < 1.0 or abs(off[-1]) > 0.35*most or x[-1] - x[0] < LENGTH:
        return []
    begin = float(numpy.mean(x[side*off > 0.95*most])) - MIDDLE
    b, edges = width_of(vehicle, width), []
    right = -0.5*(1.1*b + 0.25)  # of the first lane, about the path
    for length, times, plus, edge in SECTIONS:
        if times is not None:
            for offset in (edge + right, edge + right + times*b + plus):
                edges.append(("ISO 3888-1", numpy.array([begin, begin + length]),
                              y[0] + side*numpy.array([offset, offset])))
        begin += length
    return edges
