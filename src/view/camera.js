
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => {
  const length = Math.hypot(...a) || 1;
  return a.map((value) => value / length);
};
/** Half the tangent of the perspective's field of view: 30°. */
const FIELD = Math.tan(Math.PI / 12);
const DEGREE = Math.PI / 180;

/** The viewpoint. Directions are those of the machine: to the right, away, up; a turning machine has its Z to the
 * right and its X towards the turret: up, or down to a turret in front of the axis. */
class Camera {
  constructor(turning, down) {
    const x = down ? -1 : 1;
    /** Right, away and up in coordinates of the part. */
    this.basis = turning ? [[0, 0, 1], [0, -x, 0], [x, 0, 0]] : [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    this.presets = turning
      ? { iso: [38, 24 * x], plan: [0, 0], above: [0, 90 * x], face: [90, 0] }
      : { iso: [-45, 35.264], plan: [0, 90], front: [0, 0], side: [90, 0] };
    this.centre = [0, 0, 0];
    this.radius = 1;
    /** Points that a fit takes in beside the box. */
    this.beside = [];
    this.target = [0, 0, 0];
    this.half = 1;
    this.flat = true;
    this.section = false;
    this.look(this.presets.iso);
  }

  look([azimuth, elevation]) {
    this.azimuth = azimuth * DEGREE;
    this.elevation = elevation * DEGREE;
  }

  /** A preset by name: free is in perspective, the others are orthographic; the section is cut through the middle. */
  preset(name) {
    this.flat = name !== "free";
    if (name === "section") this.section = true;
    if (name === "section") this.look(this.presets.front ?? this.presets.plan);
    else if (this.presets[name]) this.look(this.presets[name]);
    this.fit();
  }

  /** Sets what to show: the minimum and maximum coordinates. */
  bounds(low, high) {
    this.centre = low.map((value, axis) => (value + high[axis]) / 2);
    this.radius = Math.max(Math.hypot(...high.map((value, axis) => value - low[axis])) / 2, 1e-3);
    this.box = [low, high];
    this.fit();
  }

  /** Fits the box and what is beside it into the view. */
  fit(aspect = this.aspect ?? 1) {
    this.aspect = aspect;
    this.target = this.centre.slice();
    if (!this.box) return;
    const { right, up, eye } = this.axes();
    const ends = [[Infinity, -Infinity], [Infinity, -Infinity]];
    const take = (point) => {
      const by = point.map((value, axis) => value - this.centre[axis]);
      [right, up].forEach((way, at) => (ends[at] = [Math.min(ends[at][0], dot(by, way)), Math.max(ends[at][1], dot(by, way))]));
    };
    for (let corner = 0; corner < 8; corner++) take([0, 1, 2].map((axis) => this.box[corner >> axis & 1][axis]));
    this.beside.forEach(take);
    const [aside, above] = ends.map(([from, to]) => (from + to) / 2), [wide, tall] = ends.map(([from, to]) => (to - from) / 2);
    this.target = this.centre.map((value, axis) => value + right[axis] * aside + up[axis] * above);
    // In perspective what is nearer looks larger: a box has room to spare there, what stands out of it has not.
    const larger = this.flat ? [] : this.beside.map((point) => {
      const by = point.map((value, axis) => value - this.target[axis]);
      return Math.max(Math.abs(dot(by, up)), Math.abs(dot(by, right)) / aspect) + FIELD * dot(by, eye);
    });
    this.half = Math.max(tall, wide / aspect, this.radius * 0.02, ...larger) * 1.12;
  }

  world(direction) {
    return [0, 1, 2].map((axis) => [0, 1, 2].reduce((sum, row) => sum + this.basis[row][axis] * direction[row], 0));
  }

  /** To the right, up, and towards the eye, in coordinates of the part. */
  axes() {
    const [sa, ca, se, ce] = [Math.sin(this.azimuth), Math.cos(this.azimuth), Math.sin(this.elevation), Math.cos(this.elevation)];
    return {
      right: this.world([ca, sa, 0]),
      up: this.world([-se * sa, se * ca, ce]),
      eye: this.world([sa * ce, -ca * ce, se]),
    };
  }

  /** The matrix, column by column, from the part to the screen, and the eye: a direction, or a place with a 1 behind it. */
  matrix(aspect) {
    if (this.aspect !== aspect) {
      if (this.aspect && this.untouched) this.fit(aspect);
      this.aspect = aspect;
    }
    const { right, up, eye } = this.axes();
    const deep = this.radius * 1.5 + Math.hypot(...this.target.map((value, axis) => value - this.centre[axis])) + this.half;
    const row = (axis, scale, shift = 0) => [...axis.map((value) => value * scale), shift - dot(axis, this.target) * scale];
    let rows;
    if (this.flat) {
      rows = [row(right, 1 / (this.half * aspect)), row(up, 1 / this.half), row(eye, -1 / deep), [0, 0, 0, 1]];
    } else {
      const distance = this.half / FIELD, near = Math.max(distance - deep, distance * 0.01), far = distance + deep;
      const w = row(eye, -1, distance);
      const slope = (far + near) / (far - near), shift = (-2 * far * near) / (far - near);
      rows = [row(right, 1 / (FIELD * aspect)), row(up, 1 / FIELD), w.map((value, at) => value * slope + (at === 3 ? shift : 0)), w];
    }
    const matrix = new Float32Array(16);
    rows.forEach((values, at) => values.forEach((value, column) => (matrix[4 * column + at] = value)));
    const distance = this.half / FIELD;
    const place = this.flat ? [...eye, 0] : [...this.target.map((value, axis) => value + eye[axis] * distance), 1];
    return { matrix, eye: place };
  }

  /** The plane that parts what is seen from what is cut away: what lies towards the one who looks from the front. */
  plane() {
    if (!this.section) return [0, 0, 0, 1e9];
    const away = this.basis[1];
    // A little before the middle: points of a body that lie in the plane itself are kept.
    return [...away, -dot(away, this.sectionAt ?? this.centre) + this.radius * 1e-4];
  }

  turn(dx, dy) {
    this.untouched = false;
    this.azimuth -= dx * 0.008;
    this.elevation = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, this.elevation + dy * 0.008));
  }

  /** Shifts by pixels, in a view of the given height in pixels. */
  shift(dx, dy, height) {
    this.untouched = false;
    const { right, up } = this.axes(), scale = (2 * this.half) / height;
    this.target = this.target.map((value, axis) => value - right[axis] * dx * scale + up[axis] * dy * scale);
  }

  /** Nearer by a factor, about a point given in pixels from the middle. */
  zoom(factor, x, y, height) {
    this.untouched = false;
    const half = Math.max(this.radius * 1e-4, Math.min(this.radius * 50, this.half / factor));
    const grown = 1 - half / this.half;
    this.shift(-x * grown, -y * grown, height);
    this.half = half;
  }
}
