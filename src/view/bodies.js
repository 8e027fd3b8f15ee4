
/** Directions that differ by less than this share one normal where faces meet: 32°. */
const CREASE = Math.cos(32 * DEGREE);

/** Triangles with a normal at each corner: x, y, z, nx, ny, nz. Faces at small angles look round. */
function smooth(points, triangles) {
  const count = triangles.length / 3, faces = new Float32Array(3 * count), weight = new Float32Array(count);
  const corner = (index) => [points[3 * index], points[3 * index + 1], points[3 * index + 2]];
  const starts = new Uint32Array(points.length / 3 + 1);
  for (let face = 0; face < count; face++) {
    const [a, b, c] = [0, 1, 2].map((at) => corner(triangles[3 * face + at]));
    const normal = cross(b.map((value, axis) => value - a[axis]), c.map((value, axis) => value - a[axis]));
    weight[face] = Math.hypot(...normal);
    faces.set(unit(normal), 3 * face);
    for (let at = 0; at < 3; at++) starts[triangles[3 * face + at] + 1]++;
  }
  for (let at = 1; at < starts.length; at++) starts[at] += starts[at - 1];
  const around = new Uint32Array(3 * count), filled = starts.slice();
  for (let at = 0; at < 3 * count; at++) around[filled[triangles[at]]++] = Math.floor(at / 3);
  const out = new Float32Array(18 * count);
  for (let at = 0; at < 3 * count; at++) {
    const index = triangles[at], face = Math.floor(at / 3);
    const own = faces.subarray(3 * face, 3 * face + 3), normal = [0, 0, 0];
    for (let next = starts[index]; next < starts[index + 1]; next++) {
      const other = faces.subarray(3 * around[next], 3 * around[next] + 3);
      if (dot(own, other) >= CREASE) for (let axis = 0; axis < 3; axis++) normal[axis] += other[axis] * weight[around[next]];
    }
    out.set(corner(index), 6 * at);
    out.set(weight[face] > 0 ? unit(normal) : [0, 0, 1], 6 * at + 3);
  }
  return out;
}

/** A body that is turned about its Z: outline of radius and height, from below upwards. */
function revolved(outline) {
  const round = 40, triangles = [];
  const rows = [[0, outline[0][1]], ...outline, [0, outline[outline.length - 1][1]]];
  const points = new Float64Array(rows.length * round * 3);
  rows.forEach(([radius, height], row) => {
    for (let at = 0; at < round; at++) {
      const angle = (2 * Math.PI * at) / round;
      points.set([radius * Math.cos(angle), radius * Math.sin(angle), height], 3 * (row * round + at));
      if (row === 0) continue;
      const next = (at + 1) % round, [a, b] = [(row - 1) * round + at, (row - 1) * round + next];
      const [c, d] = [row * round + next, row * round + at];
      triangles.push(a, b, c, a, c, d);
    }
  });
  return smooth(points, triangles);
}

/** The triangles of a polygon in (z, x), by cutting off ears; indices. */
function triangulated(polygon) {
  const area = polygon.reduce((sum, [z, x], at) => {
    const next = polygon[(at + 1) % polygon.length];
    return sum + z * next[1] - next[0] * x;
  }, 0);
  const left = polygon.map((_, at) => at), triangles = [];
  if (area < 0) left.reverse();
  const turn = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  for (let tries = 0; left.length > 3 && tries < left.length; ) {
    const [p, q, r] = [left[left.length - 1], left[0], left[1]];
    const [a, b, c] = [p, q, r].map((at) => polygon[at]);
    const inside = (at) => {
      const point = polygon[at];
      return at !== p && at !== q && at !== r && turn(a, b, point) >= 0 && turn(b, c, point) >= 0 && turn(c, a, point) >= 0;
    };
    if (turn(a, b, c) > 0 && !left.some(inside)) {
      triangles.push(p, q, r);
      left.shift();
      tries = 0;
    } else {
      left.push(left.shift());
      tries++;
    }
  }
  if (left.length === 3) triangles.push(...left);
  return triangles;
}

/** A plate in the plane of a turning machine, so thick to both sides. */
function plate(polygon, half) {
  if (polygon.length < 3) return new Float32Array(0);
  const count = polygon.length, points = new Float64Array(6 * count), triangles = [];
  polygon.forEach(([z, x], at) => {
    points.set([x, half, z], 3 * at);
    points.set([x, -half, z], 3 * (count + at));
    const next = (at + 1) % count;
    triangles.push(at, next, count + next, at, count + next, count + at);
  });
  const face = triangulated(polygon);
  for (let at = 0; at < face.length; at += 3) {
    triangles.push(face[at], face[at + 1], face[at + 2]);
    triangles.push(count + face[at], count + face[at + 2], count + face[at + 1]);
  }
  return smooth(points, triangles);
}

/** A tool's bodies in its own coordinates: those of the part moved by the tool's point, with Z along its axis. `size` is
 * that of the part, for tools whose form is not known. */
function toolBodies(tool, turning, size) {
  const list = (flat) => Array.from(flat, ([z, x]) => [z, x]);
  if (tool?.shape.flat) {
    const { cutting, holder, turret } = tool.shape.flat;
    const reach = Math.max(1, ...holder.concat(cutting).flat().map(([z, x]) => Math.max(Math.abs(z), Math.abs(x))));
    return [
      ...turret.map((one) => ({ vertices: plate(list(one), reach * 0.09), paint: "fixture" })),
      ...holder.map((one) => ({ vertices: plate(list(one), reach * 0.1), paint: "holder" })),
      ...cutting.map((one) => ({ vertices: plate(list(one), reach * 0.11), paint: "cutter" })),
    ];
  }
  if (tool?.shape.held) {
    const { cutting, holder } = tool.shape.held;
    return [{ vertices: revolved(cutting), paint: "cutter" }, { vertices: revolved(holder), paint: "holder" }];
  }
  if (tool) return [{ vertices: revolved(tool.shape.revolved ?? tool.shape.torch), paint: "cutter" }];
  const unitSize = size * 0.04;
  if (turning) {
    const [a, b] = [unitSize * 0.6, unitSize * 1.6];
    return [{ vertices: plate([[0, 0], [a, b], [0, 2 * b], [-a, b]], unitSize * 0.25), paint: "cutter" }];
  }
  return [{ vertices: revolved([[0, 0], [unitSize * 0.55, unitSize * 1.6], [unitSize * 0.55, unitSize * 4]]), paint: "cutter" }];
}

/** The matrix, column by column, that puts a tool on a point with its Z along a direction. */
function standing(point, direction) {
  const aside = Math.abs(direction[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0];
  const x = unit(cross(aside, direction)), y = cross(direction, x);
  return new Float32Array([...x, 0, ...y, 0, ...direction, 0, ...point, 1]);
}

/** The matrix that leaves everything where it is. */
const STILL = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);

/** A round number not below another: 1, 2 or 5 with noughts. */
function round125(value) {
  const ten = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].map((step) => step * ten).find((step) => step >= value * 0.999);
}

/** Lines of a grid below the part (of a turning machine through its axis), and the axes; as a path's points with paints
 * for kinds. */
function gridLines(low, high, turning) {
  const [first, second, across] = turning ? [2, 0, 1] : [0, 1, 2];
  const size = Math.max(high[first] - low[first], high[second] - low[second], 1e-3);
  const step = round125(size / 12), level = turning ? 0 : Math.min(low[2], high[2]);
  const lines = [];
  const line = (from, to, paint) => {
    lines.push(...from, -1, -1, ...to, -1, paint);
  };
  const at = (a, b) => {
    const point = [0, 0, 0];
    point[first] = a; point[second] = b; point[across] = level;
    return point;
  };
  const range = (axis) => [Math.floor(low[axis] / step - 1) * step, Math.ceil(high[axis] / step + 1) * step];
  const [a0, a1] = range(first), [b0, b1] = range(second);
  for (let a = a0; a <= a1 + step / 2; a += step) line(at(a, b0), at(a, b1), GRID);
  for (let b = b0; b <= b1 + step / 2; b += step) line(at(a0, b), at(a1, b), GRID);
  const long = 0.16 * size;
  [AXIS_X, AXIS_X + 1, AXIS_X + 2].forEach((paint, axis) => {
    const end = [0, 0, 0];
    end[axis] = long;
    line([0, 0, 0], end, paint);
  });
  return { lines: new Float32Array(lines), step };
}

/** Paints of lines beside the kinds of motions. */
const GRID = 6, AXIS_X = 7, CURVE = 10, AXIS_TOOL = 11;

/** Colours, light and dark. */
const COLOURS = {
  rapid: ["#d9480f", "#ff9d5c"], feed: ["#1668c9", "#62b0ff"], thread: ["#8a1fb5", "#d58bff"], grid: ["#c3cad3", "#39424d"],
  x: ["#c92a2a", "#ff7b72"], y: ["#2b8a3e", "#69db7c"], z: ["#1c4fd7", "#74a7ff"], curve: ["#c2255c", "#ff8fb8"],
  metal: ["#b8bec6", "#8f99a5"], blade: ["#c9a14a", "#c9a552"], splitter: ["#7fa88c", "#7fae91"], ghost: ["#8fa3b8", "#7f95ab"],
  fixture: ["#7a828c", "#5d6670"], cutter: ["#e0a400", "#f0bd2c"], holder: ["#6a7684", "#76828f"], cut: ["#e6b8a2", "#a9735c"],
  ground: ["#f4f5f7", "#14171b"], text: ["#1b2027", "#e6e9ed"],
};
const dark = matchMedia("(prefers-color-scheme: dark)");
const colour = (name) => COLOURS[name][dark.matches ? 1 : 0];
const light = (name) => {
  const hex = parseInt(colour(name).slice(1), 16);
  return [(hex >> 16) / 255, ((hex >> 8) & 255) / 255, (hex & 255) / 255];
};
/** The colours of a line's kinds. */
const LINE_COLOURS = ["rapid", "feed", "feed", "feed", "thread", "feed", "grid", "x", "y", "z", "curve", "holder"];
