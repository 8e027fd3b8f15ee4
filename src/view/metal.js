
/** Changes between two kept states of the metal. */
const KEEP = 256;

/** The outlines of turned metal at any motion. An outline is a list of z, r, z, r …; none is changed once it is made. */
class Metal {
  constructor(data) {
    const outlines = ({ lengths, points }) => {
      const all = numbers(points);
      let at = 0;
      return Array.from(wholes(lengths), (length) => all.slice(2 * at, 2 * (at += length)));
    };
    const stock = outlines(data.stock);
    this.stock = stock;
    this.parted = data.parted && { motion: data.parted.motion, outlines: outlines(data.parted.piece) };
    this.edits = wholes(data.edits);
    this.count = this.edits.length / 5;
    this.inserted = numbers(data.inserted);
    this.offsets = new Uint32Array(this.count + 1);
    for (let edit = 0; edit < this.count; edit++) this.offsets[edit + 1] = this.offsets[edit] + this.edits[5 * edit + 4];
    this.kept = [stock];
    this.now = { edit: 0, outlines: stock };
    this.fixtures = data.fixtures.map((fixture) => ({ name: fixture.name, outline: numbers(fixture.outline) }));
    this.found = { motion: -2 };
  }

  /** The piece that the last cut has parted off, once it has. */
  piece(motion, part) {
    const { parted } = this;
    if (!parted || motion + part < parted.motion + 1) return null;
    parted.pieces ??= outlinePieces(parted.outlines);
    return parted.pieces;
  }

  /** The first change of a motion or of a later one. */
  editOf(motion) {
    let low = 0, high = this.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.edits[5 * middle] >= motion) high = middle;
      else low = middle + 1;
    }
    return low;
  }

  /** The outlines after so many changes. */
  after(edits) {
    if (this.now.edit > edits || edits - this.now.edit > KEEP) {
      const nearest = Math.min(Math.floor(edits / KEEP), this.kept.length - 1);
      if (this.now.edit > edits || this.now.edit < nearest * KEEP) {
        this.now = { edit: nearest * KEEP, outlines: this.kept[nearest] };
      }
    }
    while (this.now.edit < edits) {
      this.now = { edit: this.now.edit + 1, outlines: this.changed(this.now.outlines, this.now.edit) };
      if (this.now.edit === this.kept.length * KEEP) this.kept.push(this.now.outlines);
    }
    return this.now.outlines;
  }

  changed(outlines, edit) {
    const [, slot, start, deleted] = this.edits.subarray(5 * edit, 5 * edit + 4);
    const before = outlines[slot] ?? new Float64Array(0);
    const inserted = this.inserted.subarray(2 * this.offsets[edit], 2 * this.offsets[edit + 1]);
    const after = new Float64Array(before.length - 2 * deleted + inserted.length);
    after.set(before.subarray(0, 2 * start));
    after.set(inserted, 2 * start);
    after.set(before.subarray(2 * (start + deleted)), 2 * start + inserted.length);
    const list = outlines.slice();
    list[slot] = after;
    return list;
  }

  /** The outlines before and after a motion. */
  around(motion) {
    if (this.found.motion !== motion) {
      const first = this.editOf(motion), last = this.editOf(motion + 1);
      const before = this.after(first);
      this.found = { motion, before, after: this.after(last), cuts: last > first };
    }
    return this.found;
  }

  /**
   * What stands while a motion is partly done: behind the line through the tool across its heading the metal after it,
   * before that line the metal before it. As pieces of outlines `[z, r, z, r, nz, nr, nz, nr]` with the directions out of
   * the metal at both ends.
   */
  pieces(motion, part, tip, heading) {
    const { before, after, cuts } = this.around(motion);
    if (!cuts || part >= 1) return outlinePieces(after);
    if (part <= 0 || !heading) return outlinePieces(before);
    const out = [], crossed = [];
    const cut = { at: [tip[2], tip[0]], d: [heading[2], heading[0]] };
    for (const outline of after) surface(outline, (...piece) => clipped(piece, cut, -1, out, crossed), true);
    for (const outline of before) surface(outline, (...piece) => clipped(piece, cut, 1, out, crossed), true);
    // Along the line, what of the metal before has none behind it: between odd and even crossings of both.
    crossed.sort((one, other) => one - other);
    const [z, r] = cut.at, [dz, dr] = cut.d;
    for (let at = 0; at + 1 < crossed.length; at += 2) {
      const [low, high] = [crossed[at], crossed[at + 1]];
      if (high - low < 1e-9) continue;
      out.push(z - dr * low, r + dz * low, z - dr * high, r + dz * high, -dz, -dr, -dz, -dr);
    }
    return new Float32Array(out);
  }
}

/** All pieces of outlines. */
function outlinePieces(outlines) {
  const out = [];
  for (const outline of outlines) surface(outline, (...piece) => out.push(...piece));
  return new Float32Array(out);
}

const onAxis = (one, other) => one < 1e-9 && other < 1e-9;

/** Calls `each` for every edge of an outline off the axis (or with `all` for those on it too), with the directions out of
 * the metal at both ends: edges that bend little share one where they meet. */
function surface(outline, each, all = false) {
  const count = outline.length / 2;
  const normal = (edge) => {
    const one = 2 * ((edge + count) % count), other = 2 * ((edge + 1 + count) % count);
    const dz = outline[other] - outline[one], dr = outline[other + 1] - outline[one + 1], length = Math.hypot(dz, dr) || 1;
    return [dr / length, -dz / length];
  };
  for (let edge = 0; edge < count; edge++) {
    const a = 2 * edge, b = 2 * ((edge + 1) % count);
    if (!all && onAxis(outline[a + 1], outline[b + 1])) continue;
    const own = normal(edge);
    const shared = (other) => {
      if (own[0] * other[0] + own[1] * other[1] < 0.86) return own;
      const [z, r] = [own[0] + other[0], own[1] + other[1]], length = Math.hypot(z, r);
      return [z / length, r / length];
    };
    const [p, q] = [shared(normal(edge - 1)), shared(normal(edge + 1))];
    each(outline[a], outline[a + 1], outline[b], outline[b + 1], p[0], p[1], q[0], q[1]);
  }
}

/** Keeps the part of an edge on one side of a line (−1 behind it, 1 before it) and notes where it crosses. */
function clipped(piece, cut, side, out, crossed) {
  const [za, ra, zb, rb] = piece;
  const height = (z, r) => ((z - cut.at[0]) * cut.d[0] + (r - cut.at[1]) * cut.d[1]) * side;
  const a = height(za, ra), b = height(zb, rb), seen = !onAxis(ra, rb);
  if (a < 0 && b < 0) return;
  if (a >= 0 && b >= 0) {
    if (seen) out.push(...piece);
    return;
  }
  const share = a / (a - b), z = za + (zb - za) * share, r = ra + (rb - ra) * share;
  crossed.push((z - cut.at[0]) * -cut.d[1] + (r - cut.at[1]) * cut.d[0]);
  if (!seen) return;
  const kept = piece.slice();
  if (a >= 0) { kept[2] = z; kept[3] = r; } else { kept[0] = z; kept[1] = r; }
  out.push(...kept);
}
