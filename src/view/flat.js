
/** Most pieces of a path that are drawn, and most triangles of a body: more would take too long without WebGL. */
const FLAT_LINES = 60000, FLAT_TRIANGLES = 12000;

/** Draws the same on a 2-D canvas: bodies as shaded triangles from back to front, turned metal as its cut face. */
class Flat {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.name = "2d";
  }

  forget() {}

  drop() {}

  begin(camera, width, height, ratio) {
    if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, { width, height });
    this.camera = camera.matrix(width / height);
    this.plane = camera.plane();
    this.cut = camera.section;
    this.ratio = ratio;
    this.triangles = 0;
    this.context.fillStyle = colour("ground");
    this.context.fillRect(0, 0, width, height);
  }

  /** A point on the canvas, and how deep it lies. */
  project(x, y, z) {
    const m = this.camera.matrix, { width, height } = this.canvas;
    const w = m[3] * x + m[7] * y + m[11] * z + m[15] || 1e-6;
    const to = (row) => (m[row] * x + m[row + 4] * y + m[row + 8] * z + m[row + 12]) / w;
    return [(to(0) + 1) * 0.5 * width, (1 - to(1)) * 0.5 * height, to(2)];
  }

  mesh(vertices, paint, alpha = 1, model = STILL, whole = false) {
    const context = this.context, [red, green, blue] = light(paint), faces = [];
    const count = vertices.length / 18, stride = Math.max(1, Math.ceil(count / FLAT_TRIANGLES));
    if (stride > 1 && alpha < 1) return;
    const place = (at) => {
      const [x, y, z] = vertices.subarray(at, at + 3);
      return [0, 1, 2].map((row) => model[row] * x + model[row + 4] * y + model[row + 8] * z + model[row + 12]);
    };
    for (let face = 0; face < count; face++) {
      const corners = [0, 6, 12].map((corner) => place(18 * face + corner));
      if (!whole && corners.some((corner) => dot(this.plane, corner) + this.plane[3] < 0)) continue;
      const normal = unit(cross(corners[1].map((v, i) => v - corners[0][i]), corners[2].map((v, i) => v - corners[0][i])));
      const towards = dot(normal, unit(this.camera.eye.slice(0, 3))), facing = Math.abs(towards);
      if (towards < 0 && alpha === 1 && !this.cut) continue;
      const points = corners.map((corner) => this.project(...corner));
      faces.push({ points, facing, deep: points[0][2] + points[1][2] + points[2][2] });
    }
    faces.sort((one, other) => other.deep - one.deep);
    context.globalAlpha = alpha;
    for (const { points, facing } of faces) {
      const shade = 255 * (0.45 + 0.55 * facing);
      context.fillStyle = context.strokeStyle = `rgb(${red * shade},${green * shade},${blue * shade})`;
      context.beginPath();
      points.forEach(([x, y]) => context.lineTo(x, y));
      context.closePath();
      context.fill();
      if (alpha === 1) context.stroke();
    }
    context.globalAlpha = 1;
    this.triangles += faces.length;
  }

  /** The cut face of what is turned: every piece of an outline with its way to the axis, on both sides of it. A hollow's
   * pieces run the other way and take their share off again. */
  turn(pieces, paint, alpha = 1) {
    const context = this.context;
    context.globalAlpha = alpha;
    context.fillStyle = colour(paint);
    context.beginPath();
    for (const side of [1, -1]) {
      for (let at = 0; at < pieces.length; at += 8) {
        const [z0, r0, z1, r1] = pieces.subarray(at, at + 4);
        [[0, z0], [side * r0, z0], [side * r1, z1], [0, z1]].forEach(([x, z], corner) => {
          const [px, py] = this.project(x, 0, z);
          if (corner === 0) context.moveTo(px, py);
          else context.lineTo(px, py);
        });
        context.closePath();
      }
    }
    context.fill("nonzero");
    context.globalAlpha = 1;
    this.triangles += pieces.length / 4;
  }

  lines(path, { hidden = [], now = Infinity, rest = 1, width = 1.6, first = 0, most = Infinity } = {}) {
    const context = this.context, count = Math.min(path.length / 5, first + most);
    const stride = Math.max(1, Math.ceil((count - first) / FLAT_LINES));
    context.lineWidth = width * this.ratio;
    let last = null, style = "";
    for (let at = first; at < count; at += stride) {
      const [x, y, z, cursor, kind] = path.subarray(5 * at, 5 * at + 5);
      const point = this.project(x, y, z);
      const share = cursor <= now ? 1 : rest;
      if (kind >= 0 && last && share > 0 && !hidden.includes(kind)) {
        const wanted = `${kind} ${share}`;
        if (wanted !== style) {
          if (style) context.stroke();
          style = wanted;
          context.globalAlpha = share;
          context.strokeStyle = colour(LINE_COLOURS[kind]);
          context.beginPath();
        }
        context.moveTo(last[0], last[1]);
        context.lineTo(point[0], point[1]);
        this.triangles++;
      }
      last = point;
    }
    if (style) context.stroke();
    context.globalAlpha = 1;
  }

  end() {}
}
