"""A model with wheels: what its sensors and its free joint say about a vehicle.

x forward, y left, z up at the start; the vehicle body carries the wheels and stands on the ground by
the joint that is a free one, or has sensors.
"""
import numpy

G = 9.80665
STANDSTILL = 0.1  # slower than that a path has no direction [m/s]
AXLE_GAP = 0.5  # wheels further apart along x are on different axles [m]


def is_vehicle(run):
    return bool(run.model.get("wheels"))


class Channel:
    """A quantity over time, and where it comes from."""

    def __init__(self, label, unit, values, source=""):
        self.label, self.unit, self.values, self.source = label, unit, values, source


class Axle:
    def __init__(self, name, wheels):
        self.name, self.wheels = name, wheels
        self.x = float(numpy.mean([w["point"][0] for w in wheels]))

    def side(self, side):
        return [w for w in self.wheels if w["side"] == side]

    def track(self):
        """Distance of the middles of both sides [m]; None with one side only."""
        middles = [numpy.mean([w["point"][1] for w in self.side(s)])
                   for s in ("left", "right") if self.side(s)]
        return abs(float(middles[0] - middles[1])) if len(middles) == 2 else None


class Vehicle:
    def __init__(self, run):
        self.run, self.t = run, run.t
        self.wheels = run.model["wheels"]
        self.parents = {b["name"]: b["parent"] for b in run.model["bodies"]}
        self.joints = {b["name"]: b["joint"] for b in run.model["bodies"]}
        self.body = self.root()
        self.axles = self.find_axles()
        self.channel = {}
        self.motion()
        self.attitude()
        self.steering()
        self.drive()
        self.tyres()

    # ---------------------------------------------------------------- what it is made of

    def ancestors(self, body):
        line = [body]
        while self.parents.get(line[-1]) not in (None, "ground"):
            line.append(self.parents[line[-1]])
        return line

    def root(self):
        """Of the bodies on the ground the heaviest, with all that hangs on it."""
        mass = {}
        for path, value in self.run.parameter.items():
            words = path.split(".")
            if words[0] == "bodies" and words[-1] == "mass" and words[1] in self.parents:
                top = self.ancestors(words[1])[-1]
                mass[top] = mass.get(top, 0.0) + value
        return max(mass, key=mass.get, default=None)

    def find_axles(self):
        ordered = sorted(self.wheels, key=lambda w: -w["point"][0])
        groups = [[ordered[0]]]
        for wheel in ordered[1:]:
            if groups[-1][-1]["point"][0] - wheel["point"][0] > AXLE_GAP:
                groups.append([])
            groups[-1].append(wheel)
        names = ["front", "rear"] if len(groups) == 2 else [f"axle {k + 1}" for k in range(len(groups))]
        return [Axle(name, sorted(group, key=lambda w: -w["point"][1]))
                for name, group in zip(names, groups)]

    def wheelbase(self):
        return self.axles[0].x - self.axles[-1].x if len(self.axles) > 1 else None

    # ---------------------------------------------------------------- motion of the body

    def add(self, key, label, unit, values, source=""):
        self.channel[key] = Channel(label, unit, values, source)

    def get(self, key):
        return self.channel[key].values if key in self.channel else None

    def free(self, number, end):
        """Column of a coordinate of the free joint: z, y, x, yaw, pitch, roll from 1."""
        return self.run.table.get(f"{self.body}.{number}.{end}")

    def is_free(self):
        return self.joints.get(self.body) == "free"

    def vector(self, kind, end):
        """(x, y, z, source) of a sensor of the body, or of its free joint."""
        found = self.run.sensor_columns(kind, body=self.body)
        if {"x", "y", "z"} <= set(found):
            return found["x"], found["y"], found["z"], f"{kind} sensor on {self.body}"
        if not self.is_free():
            return None
        x, y, z = (self.free(k, end) for k in (3, 2, 1))
        point = self.run.point(f"bodies.{self.body}.joint.point")
        if end == "q" and point is not None:
            x, y, z = x + point[0], y + point[1], z + point[2]
        return x, y, z, f"joint point of {self.body}"

    def motion(self):
        position, velocity, acceleration = (self.vector(k, e) for k, e in (
            ("position", "q"), ("velocity", "v"), ("acceleration", "a")))
        if position:
            x, y, z, source = position
            self.add("x", "x", "m", x, source)
            self.add("y", "y", "m", y, source)
            self.add("z", "vertical position", "m", z, source)
        if velocity:
            x, y, z, source = velocity
            self.add("vx", "velocity along x", "m/s", x, source)
            self.add("vy", "velocity along y", "m/s", y, source)
            self.add("speed", "speed", "m/s", numpy.sqrt(x*x + y*y + z*z), source)
        if acceleration:
            self.add("az", "vertical acceleration", "m/s^2", acceleration[2], acceleration[3])
        found = self.run.sensor_columns("lateral_acceleration", body=self.body)
        if found:
            self.put_lateral(found["planar"], found["exact"], found["approximate"],
                             f"lateral_acceleration sensor on {self.body}")
        elif velocity and acceleration and velocity[3].split(" on ")[-1] == \
                acceleration[3].split(" on ")[-1]:
            self.lateral(numpy.array(velocity[:3]), numpy.array(acceleration[:3]), acceleration[3])

    def lateral(self, v, a, source):
        """[1] 3.19, its planar form 3.20 with a sign, and 3.21, for constant speed."""
        level = moving(numpy.hypot(v[0], v[1]))
        along = numpy.sum(a*v, axis=0)/(level**2 + v[2]**2)
        self.put_lateral((v[0]*a[1] - v[1]*a[0])/level, numpy.linalg.norm(a - along*v, axis=0),
                         numpy.hypot(a[0], a[1]), source)

    def put_lateral(self, planar, exact, approximate, source):
        self.add("ay", "lateral acceleration", "m/s^2", planar, source)
        self.add("ay_exact", "|a_y| exact (3.19)", "m/s^2", exact, source)
        self.add("ay_approximate", "|a_y| approximate (3.21)", "m/s^2", approximate, source)

    def attitude(self):
        names = ("roll", "pitch", "yaw")
        angles = self.run.sensor_columns("angles", body=self.body)
        rates = self.run.sensor_columns("angle_rates", body=self.body)
        for name, number in zip(names, (6, 5, 4)):
            angle, rate, acceleration = angles.get(name), rates.get(name + "_rate"), None
            if self.is_free():
                angle = self.free(number, "q") if angle is None else angle
                rate = self.free(number, "v") if rate is None else rate
                acceleration = self.free(number, "a")
            if angle is not None:
                self.add(name, f"{name} angle", "rad", angle)
            if rate is not None:
                self.add(name + "_rate", f"{name} rate", "rad/s", rate)
            if acceleration is not None:
                self.add(name + "_acceleration", f"{name} acceleration", "rad/s^2", acceleration)
        found = self.run.sensor_columns("sideslip", body=self.body)
        if found:
            self.add("sideslip", "sideslip angle", "rad", found["angle"])
        elif "vx" in self.channel and "yaw" in self.channel:
            vx, vy, yaw = self.get("vx"), self.get("vy"), self.get("yaw")
            ahead, left = vx*numpy.cos(yaw) + vy*numpy.sin(yaw), vy*numpy.cos(yaw) - vx*numpy.sin(yaw)
            self.add("sideslip", "sideslip angle", "rad",
                     numpy.arctan2(left, ahead) + 0.0*moving(numpy.hypot(vx, vy)))

    # ---------------------------------------------------------------- steering

    def steering(self):
        """The guided angle above a carrier of a wheel; of one that hangs elsewhere, any guided angle."""
        mine = set()
        for wheel in self.wheels:
            mine.update(self.ancestors(wheel["carrier"]))
        mine.discard(self.body)
        guided = [c for c in self.run.coordinates.values() if c["guided"] and c["unit"] == "rad"]
        guided = [c for c in guided if self.ancestors(owner(c, self.parents))[-1] == self.body]
        guided.sort(key=lambda c: owner(c, self.parents) not in mine)
        for c in guided[:1]:
            self.add("steer", f"steering coordinate {c['name']}", "rad", self.run.table[c["name"] + ".q"])
            self.channel["steer"].motion = c.get("motion")
        self.road_wheels()

    def road_wheels(self):
        """Mean angle about z of the carriers of the first axle against the body."""
        angles = [self.run.sensor_columns("angles", body=w["carrier"]).get("yaw")
                  for w in self.axles[0].wheels if w["carrier"] != self.body]
        if angles and not any(a is None for a in angles) and "yaw" in self.channel:
            self.add("road_wheel", "angle of the front wheels", "rad",
                     numpy.mean(angles, axis=0) - self.get("yaw"))

    # ---------------------------------------------------------------- drive

    def drive(self):
        """Torque of a speed controller on each of its wheels, where the speed of its point is measured."""
        for force in self.run.model.get("forces", []):
            path = f"forces.{force['name']}."
            keys = [self.run.parameter.get(path + key) for key in ("speed", "gain", "torque", "low_speed")]
            if not force["type"].startswith("speed") or None in keys or "function" in force:
                continue
            speed, gain, torque, low = keys
            v = self.speed_of_point(force["body"], self.run.point(path + "point"))
            if v is None:
                continue
            e = speed - numpy.sqrt(v**2 + low**2)
            law = e if "linear" in force["type"] else e*numpy.abs(e)
            self.add("torque", f"torque of {force['name']} on each wheel", "N m", gain*torque*law)
            return

    def speed_of_point(self, body, point):
        """Of the velocity sensor there, or None."""
        names = {s["sensor"] for s in self.run.sensors.values()
                 if s.get("type") == "velocity" and s.get("body") == body}
        for name in sorted(names):
            there = self.run.point(f"sensors.{name}.point")
            if point is not None and there is not None and numpy.max(numpy.abs(there - point)) < 1e-9:
                return numpy.sqrt(sum(self.run.table[f"{name}.{axis}"]**2 for axis in "xyz"))
        return None

    # ---------------------------------------------------------------- tyres

    def tyres(self):
        self.force, self.slip, self.moment = {}, {}, {}
        for wheel in self.wheels:
            name = wheel["name"]
            for kind, into in (("tyre_force", self.force), ("tyre_slip", self.slip),
                               ("tyre_moment", self.moment)):
                found = self.run.sensor_columns(kind, element=name)
                if found:
                    into[name] = found
        for axle in self.axles:
            self.transfer(axle)

    def has(self, axle, table):
        return all(w["name"] in table for w in axle.wheels)

    def vertical(self, wheels):
        return sum(self.force[w["name"]]["fz"] for w in wheels)

    def transfer(self, axle):
        if not (self.has(axle, self.force) and axle.side("left") and axle.side("right")):
            return
        left, right = self.vertical(axle.side("left")), self.vertical(axle.side("right"))
        self.add(f"transfer {axle.name}", f"load transfer {axle.name}", "N", right - left)
        with numpy.errstate(divide="ignore", invalid="ignore"):
            ratio = (right - left)/(right + left)
        self.add(f"ratio {axle.name}", f"load transfer ratio {axle.name}", "-", ratio)

    def axle_slip(self, axle):
        """Mean slip angle [rad], or None."""
        if not self.has(axle, self.slip):
            return None
        return numpy.mean([self.slip[w["name"]]["alpha"] for w in axle.wheels], axis=0)

    def friction(self, wheel):
        """Fx and Fy over the largest that the tyre can give alone at this load, or None."""
        p, tyre = self.run.parameter, f"tyres.{wheel['tyre']}."
        keys = ("fnomin", "lfzo", "pdx1", "pdx2", "lmux", "pdy1", "pdy2", "lmuy")
        if wheel["name"] not in self.force or any(tyre + key not in p for key in keys):
            return None
        fnomin, lfzo, pdx1, pdx2, lmux, pdy1, pdy2, lmuy = (p[tyre + key] for key in keys)
        f = self.force[wheel["name"]]
        load = numpy.where(f["fz"] > 0.01*fnomin, f["fz"], numpy.nan)
        df = (load - fnomin*lfzo)/(fnomin*lfzo)
        return (f["fx"]/(load*numpy.abs((pdx1 + pdx2*df)*lmux)),
                f["fy"]/(load*numpy.abs((pdy1 + pdy2*df)*lmuy)))


def moving(speed):
    """The speed where there is one, else not a number."""
    return numpy.where(speed > STANDSTILL, speed, numpy.nan)


def owner(coordinate, bodies):
    """Body of a coordinate NAME or NAME.2."""
    name = coordinate["name"]
    return name if name in bodies else name.rpartition(".")[0]
