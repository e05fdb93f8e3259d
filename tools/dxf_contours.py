"""Closed contours out of the entities of a DXF file: their areas, boxes and what they hold."""

import math

JOINT = 1e-9  # ends of a chain meet within this, in units of the file


def distance(a, b):
    return math.hypot(a[0] - b[0], a[1] - b[1])


def arc_of_bulge(a, b, bulge):
    """Centre, radius, start angle and sweep of the arc from a to b."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    f = (1 - bulge * bulge) / (4 * bulge)
    cx, cy = (a[0] + b[0]) / 2 - f * dy, (a[1] + b[1]) / 2 + f * dx
    radius = math.hypot(dx, dy) * (1 + bulge * bulge) / (4 * abs(bulge))
    return (cx, cy), radius, math.atan2(a[1] - cy, a[0] - cx), 4 * math.atan(bulge)


def box_of(points):
    xs, ys = zip(*points)
    return min(xs), min(ys), max(xs), max(ys)


class Line:
    def __init__(self, a, b):
        self.ends = (a, b)

    def green(self, o):
        a, b = self.ends
        return ((a[0] - o[0]) * (b[1] - o[1]) - (b[0] - o[0]) * (a[1] - o[1])) / 2

    def length(self):
        return distance(*self.ends)

    def points(self):
        return [self.ends[0]]

    def extremes(self):
        return self.ends


class Arc:
    def __init__(self, center, radius, start, sweep, ends=None):
        self.center, self.radius, self.start, self.sweep = center, radius, start, sweep
        self.ends = ends or (self.at(start), self.at(start + sweep))

    def at(self, angle):
        return (self.center[0] + self.radius * math.cos(angle),
                self.center[1] + self.radius * math.sin(angle))

    def green(self, o):
        # The chord's triangle and the segment beside it: no cancellation for flat arcs.
        s = self.sweep
        segment = s ** 3 / 6 if abs(s) < 1e-3 else s - math.sin(s)
        return Line(*self.ends).green(o) + self.radius ** 2 * segment / 2

    def length(self):
        return self.radius * abs(self.sweep)

    def points(self):
        n = max(2, math.ceil(abs(self.sweep) / 0.05))
        return [self.at(self.start + self.sweep * i / n) for i in range(n)]

    def extremes(self):
        low, high = sorted((self.start, self.start + self.sweep))
        quarters = range(math.ceil(low / (math.pi / 2)), math.floor(high / (math.pi / 2)) + 1)
        return [*self.ends, *(self.at(q * math.pi / 2) for q in quarters)]


class Spline:
    GAUSS = ((-math.sqrt(0.6), 5 / 9), (0.0, 8 / 9), (math.sqrt(0.6), 5 / 9))

    def __init__(self, entity):
        self.tool = entity.construction_tool()
        self.knots = list(self.tool.knots())
        poles = self.tool.control_points
        self.ends = (tuple(poles[0].vec2), tuple(poles[-1].vec2))

    def green(self, o):
        # x dy − y dx is of degree 5 on each span of a cubic: three Gauss points are exact.
        total = 0.0
        for t0, t1 in zip(self.knots, self.knots[1:]):
            if t1 <= t0:
                continue
            for x, weight in self.GAUSS:
                p, d = self.tool.derivative((t0 + t1) / 2 + x * (t1 - t0) / 2, 1)
                total += weight * (t1 - t0) / 4 * ((p.x - o[0]) * d.y - (p.y - o[1]) * d.x)
        return total

    def length(self):
        spans = len(set(self.knots)) - 1
        points = [(p.x, p.y) for p in self.tool.approximate(max(256 * spans, 256))]
        return sum(map(distance, points, points[1:]))

    def points(self):
        spans = len(set(self.knots)) - 1
        return [(p.x, p.y) for p in self.tool.approximate(max(8 * spans, 8))][:-1]

    def extremes(self):
        spans = len(set(self.knots)) - 1
        return [(p.x, p.y) for p in self.tool.approximate(max(64 * spans, 64))]


class Reversed:
    def __init__(self, piece):
        self.piece = piece
        self.ends = piece.ends[::-1]

    def green(self, o):
        return -self.piece.green(o)

    def length(self):
        return self.piece.length()

    def points(self):
        points = self.piece.points()[1:]
        return [self.ends[0]] + points[::-1]

    def extremes(self):
        return self.piece.extremes()


class Contour:
    """A closed curve: its pieces one after the other."""

    def __init__(self, pieces, layer, circle=False):
        self.pieces, self.layer, self.circle = pieces, layer, circle
        self.origin = pieces[0].ends[0]
        self.area = abs(sum(p.green(self.origin) for p in pieces))
        self.polygon = [q for p in pieces for q in p.points()]
        self.box = box_of(q for p in pieces for q in p.extremes())

    def holds(self, point):
        if not (self.box[0] <= point[0] <= self.box[2] and self.box[1] <= point[1] <= self.box[3]):
            return False
        inside, (x, y) = False, point
        ax, ay = self.polygon[-1]
        for bx, by in self.polygon:
            if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
                inside = not inside
            ax, ay = bx, by
        return inside

    def some_points(self, count):
        step = max(1, len(self.polygon) // count)
        return self.polygon[::step]


def bulge_pieces(vertices):
    """Pieces of a closed polyline of (x, y, bulge)."""
    pieces = []
    for (x0, y0, bulge), (x1, y1, _) in zip(vertices, vertices[1:] + vertices[:1]):
        a, b = (x0, y0), (x1, y1)
        pieces.append(Arc(*arc_of_bulge(a, b, bulge), (a, b)) if bulge and a != b else Line(a, b))
    return pieces


def chain_piece(entity):
    kind, dxf = entity.dxftype(), entity.dxf
    if kind == "LINE":
        return Line((dxf.start.x, dxf.start.y), (dxf.end.x, dxf.end.y))
    if kind == "ARC":
        start, end = math.radians(dxf.start_angle), math.radians(dxf.end_angle)
        return Arc((dxf.center.x, dxf.center.y), dxf.radius, start, (end - start) % (2 * math.pi))
    return Spline(entity)


def next_piece(pieces, at):
    """The loose piece that begins or ends at a point, turned to begin there; taken out of pieces."""
    for i, piece in enumerate(pieces):
        if distance(piece.ends[0], at) <= JOINT:
            return pieces.pop(i)
        if distance(piece.ends[1], at) <= JOINT:
            return Reversed(pieces.pop(i))
    return None


def chained(pieces, layer, errors, slits):
    """Contours out of loose pieces, each joined to the one whose end lies where it ends.

    Chains with two ends are slits, where there is a list for them, and errors elsewhere.
    """
    contours = []
    while pieces:
        chain, turned = [pieces.pop(0)], False
        while distance(chain[-1].ends[1], chain[0].ends[0]) > JOINT:
            found = next_piece(pieces, chain[-1].ends[1])
            if found:
                chain.append(found)
            elif not turned:
                chain, turned = [Reversed(p) for p in reversed(chain)], True
            else:
                break
        else:
            contours.append(Contour(chain, layer))
            continue
        if slits is None:
            errors.append(f"layer {layer}: an open end at {chain[-1].ends[1]}")
        else:
            slits.append(chain)
    return contours


def polyline_contour(entity, errors):
    layer = entity.dxf.layer
    if entity.dxftype() == "LWPOLYLINE":
        closed = entity.closed
        vertices = [(x, y, b) for x, y, b in entity.get_points("xyb")]
    else:
        closed = entity.is_closed
        vertices = [(v.dxf.location.x, v.dxf.location.y, v.dxf.get("bulge", 0.0))
                    for v in entity.vertices]
    if not closed or len(vertices) < 2:
        errors.append(f"layer {layer}: a polyline that is not closed")
        return None
    pieces = bulge_pieces(vertices)
    if any(distance(*p.ends) < JOINT for p in pieces):
        errors.append(f"layer {layer}: a polyline with a doubled vertex")
    if any(abs(b) > 1 + 1e-6 for _, _, b in vertices):
        errors.append(f"layer {layer}: an arc of more than half a turn")
    return Contour(pieces, layer)


def contours_of(entities, errors, slits=None, slit_layers=()):
    """Closed contours of the entities; open chains on the layers for slits go to their list."""
    contours, loose = [], {}
    for entity in entities:
        kind, layer = entity.dxftype(), entity.dxf.layer
        if kind == "CIRCLE":
            center = (entity.dxf.center.x, entity.dxf.center.y)
            pieces = [Arc(center, entity.dxf.radius, 0.0, 2 * math.pi)]
            contours.append(Contour(pieces, layer, circle=True))
        elif kind in ("LWPOLYLINE", "POLYLINE"):
            contour = polyline_contour(entity, errors)
            if contour:
                contours.append(contour)
        elif kind in ("LINE", "ARC", "SPLINE"):
            loose.setdefault(layer, []).append(chain_piece(entity))
        else:
            errors.append(f"layer {layer}: {kind} is not a contour")
    for layer, pieces in loose.items():
        contours += chained(pieces, layer, errors, slits if layer in slit_layers else None)
    return contours
