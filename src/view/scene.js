
/** The bytes of a base64 text. */
function bytesOf(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let at = 0; at < raw.length; at++) bytes[at] = raw.charCodeAt(at);
  return bytes;
}
const wholes = (text) => new Uint32Array(bytesOf(text).buffer);
const singles = (text) => new Float32Array(bytesOf(text).buffer);
const shares = (text) => new Int16Array(bytesOf(text).buffer);
/** Lengths or angles: whole numbers of 0.0001, or doubles. */
function numbers(column) {
  if (column.d !== undefined) return new Float64Array(bytesOf(column.d).buffer);
  return Float64Array.from(new Int32Array(bytesOf(column.i).buffer), (whole) => whole / 1e4);
}

const RAPID = 0, FEED = 1, CLOCKWISE = 2, COUNTER = 3, THREAD = 4, DWELL = 5, NONE = 6;
/** True for what moves nothing: a dwell, a block without motion. */
const stands = (kind) => kind === DWELL || kind === NONE;
/** First axis, second axis and the axis across, of the planes XY, ZX, YZ. */
const PLANES = [[0, 1, 2], [2, 0, 1], [1, 2, 0]];
const LETTERS = "XYZABCUVW";

/** A program with its motions. The cursor counts motions done, the one at work as a fraction. */
class Run {
  constructor(data) {
    this.data = data;
    this.blocks = data.blocks;
    this.states = data.states;
    this.line = wholes(data.line);
    this.kind = bytesOf(data.kind);
    this.count = this.kind.length;
    this.state = wholes(data.state);
    this.points = numbers(data.points);
    this.directions = shares(data.directions);
    this.axes = data.axes.map((axis) => ({ letter: axis.letter, to: numbers(axis.to) }));
    this.first = new Uint32Array(this.count + 1);
    const pieces = bytesOf(data.pieces);
    for (let at = 0; at < this.count; at++) this.first[at + 1] = this.first[at] + pieces[at];
    this.jumpAt = new Int32Array(this.count).fill(-1);
    wholes(data.jumps).forEach((motion, index) => (this.jumpAt[motion] = index));
    this.jumpPoints = numbers(data.jump_points);
    this.jumpDirections = shares(data.jump_directions);
    this.jumpPoses = numbers(data.jump_poses);
    this.arcAt = new Int32Array(this.count).fill(-1);
    wholes(data.arcs).forEach((motion, index) => (this.arcAt[motion] = index));
    this.arcs = numbers(data.arc_shapes);
    // The part of its time at which a motion bends, 0 for the others.
    this.bend = new Float64Array(this.count);
    const parts = singles(data.bend_parts);
    wholes(data.bends).forEach((motion, index) => (this.bend[motion] = parts[index]));
    const seconds = singles(data.seconds);
    this.times = new Float64Array(this.count + 1);
    for (let at = 0; at < this.count; at++) this.times[at + 1] = this.times[at] + seconds[at];
    this.total = this.times[this.count];
    this.feed = numbers(data.feed);
    // The F in force; a lead is an F on a Fanuc only. Under another code than the one that it was given under it says nothing.
    for (let at = 0, last = 0, under = null; at < this.count; at++) {
      const mode = this.states[this.state[at]].feed;
      if (this.kind[at] === RAPID || stands(this.kind[at])) this.feed[at] = under === null || under === mode ? last : NaN;
      else if (this.kind[at] !== THREAD || data.feed_codes[0] === "G98") [last, under] = [this.feed[at], mode];
    }
    // The motion code in force at each: a dwell and a block without motion leave it as it is.
    this.modal = this.kind.slice();
    for (let at = 0; at < this.count; at++) if (stands(this.kind[at])) this.modal[at] = at ? this.modal[at - 1] : NONE;
    this.still = this.kind.every((kind) => kind === NONE);
    // The first motion of each line, −1 where it has none.
    this.ofLine = new Int32Array(this.blocks.length + 2).fill(-1);
    for (let at = this.count - 1; at >= 0; at--) {
      if (this.line[at] < this.ofLine.length) this.ofLine[this.line[at]] = at;
    }
    this.metal = data.turning ? new Metal(data.turning) : null;
  }

  /** The motion at a time. */
  motionAt(time) {
    let low = 0, high = this.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.times[middle + 1] > time) high = middle;
      else low = middle + 1;
    }
    return low;
  }

  /** The cursor at a time. */
  cursorAt(time) {
    // At the beginning no block has been executed, and at the end all, though the first and last ones may take no time.
    if (time <= 0) return 0;
    if (time >= this.total) return this.count;
    const motion = this.motionAt(time);
    if (motion >= this.count) return this.count;
    const takes = this.times[motion + 1] - this.times[motion];
    return motion + (takes > 0 ? Math.max(0, time - this.times[motion]) / takes : 0);
  }

  /** The time at a cursor. */
  timeAt(cursor) {
    const motion = Math.min(Math.floor(cursor), this.count);
    if (motion >= this.count) return this.total;
    return this.times[motion] + (this.times[motion + 1] - this.times[motion]) * (cursor - motion);
  }

  /** The motion at work and how much of it is done: a cursor between two motions stands at the end of the first. */
  at(cursor) {
    if (this.count === 0) return [-1, 0];
    const motion = Math.min(Math.max(Math.ceil(cursor) - 1, 0), this.count - 1);
    return [motion, Math.min(Math.max(cursor - motion, 0), 1)];
  }

  startOf(motion) {
    const jump = this.jumpAt[motion];
    if (jump >= 0) return this.jumpPoints.subarray(3 * jump, 3 * jump + 3);
    const before = this.first[motion] - 1;
    return this.points.subarray(3 * before, 3 * before + 3);
  }

  /** The point of the path at a part of a motion, mm. */
  point(motion, part) {
    const from = this.startOf(motion), first = this.first[motion], count = this.first[motion + 1] - first;
    const point = (index) => this.points.subarray(3 * (first + index), 3 * (first + index) + 3);
    if (part >= 1) return Array.from(point(count - 1));
    const arc = this.arcAt[motion];
    if (arc >= 0) {
      const [plane, x, y, sweep] = this.arcs.subarray(4 * arc, 4 * arc + 4);
      const [a, b, c] = PLANES[plane];
      const start = Math.atan2(from[b] - y, from[a] - x), radius = Math.hypot(from[b] - y, from[a] - x);
      const at = [0, 0, 0];
      at[a] = x + radius * Math.cos(start + sweep * part);
      at[b] = y + radius * Math.sin(start + sweep * part);
      at[c] = from[c] + (point(0)[c] - from[c]) * part;
      return at;
    }
    const along = part * count, bend = this.bend[motion];
    const piece = bend > 0 ? (part < bend ? 0 : 1) : Math.min(Math.floor(along), count - 1);
    // The pieces of a motion take the same time, but for one that bends.
    const share = bend > 0 ? (piece === 0 ? part / bend : (part - bend) / (1 - bend)) : along - piece;
    const one = piece === 0 ? from : point(piece - 1), other = point(piece);
    return [0, 1, 2].map((axis) => one[axis] + (other[axis] - one[axis]) * share);
  }

  /** The direction of the tool's axis, from the tip upwards. */
  direction(motion, part) {
    if (this.directions.length === 0) return [0, 0, 1];
    const first = this.first[motion], count = this.first[motion + 1] - first, jump = this.jumpAt[motion];
    const of = (index) => this.directions.subarray(3 * index, 3 * index + 3);
    const along = part * count, piece = Math.min(Math.floor(along), count - 1), share = along - piece;
    const one = piece > 0 ? of(first + piece - 1) : jump >= 0 ? this.jumpDirections.subarray(3 * jump, 3 * jump + 3) : of(first - 1);
    const other = of(first + piece);
    const mixed = [0, 1, 2].map((axis) => one[axis] + (other[axis] - one[axis]) * share);
    const length = Math.hypot(...mixed) || 1;
    return mixed.map((value) => value / length);
  }

  /** The direction in which the tool moves at a part of a motion; null where it stands. */
  heading(motion, part) {
    const step = 1e-4, low = Math.max(0, part - step);
    const one = this.point(motion, low), other = this.point(motion, Math.min(1, low + 2 * step));
    const by = other.map((value, axis) => value - one[axis]), length = Math.hypot(...by);
    return length > 1e-12 ? by.map((value) => value / length) : null;
  }

  /** What the display shows: letter, value in mm or degrees (X as a diameter where it is one), and whether it is an angle. */
  readout(motion, part) {
    const shown = [];
    const shift = motion < 0 ? [0, 0, 0] : this.states[this.state[motion]].shift;
    const point = motion < 0 ? shift : this.point(motion, part).map((value, axis) => value - shift[axis]);
    if (this.data.diameter) shown.push(["X", 2 * point[0], false], ["Z", point[2], false]);
    else if (this.data.plain) point.forEach((value, axis) => shown.push([LETTERS[axis], value, false]));
    for (const axis of this.axes) {
      const to = motion < 0 ? 0 : axis.to[motion];
      const jump = motion < 0 ? -1 : this.jumpAt[motion];
      const from = jump >= 0 ? this.jumpPoses[9 * jump + LETTERS.indexOf(axis.letter)] : motion > 0 ? axis.to[motion - 1] : to;
      shown.push([axis.letter, part >= 1 ? to : from + (to - from) * part, "ABC".includes(axis.letter)]);
    }
    return shown;
  }

  /** Spindle speed in rpm; null where a surface speed has no end at the axis. */
  rpm(motion, part) {
    const state = this.states[this.state[motion]];
    if (!state.surface) return state.speed;
    const diameter = 2 * Math.abs(this.point(motion, part)[0] - state.shift[0]);
    const wanted = diameter > 0 ? (1000 * state.speed) / (Math.PI * diameter) : Infinity;
    const speed = Math.min(wanted, state.greatest ?? Infinity);
    return Number.isFinite(speed) ? speed : null;
  }

  /** The cursor at a line: after its first motion, or where it has none, before the next line that has one. */
  cursorOfLine(line) {
    const motion = this.ofLine[line] ?? -1;
    if (motion >= 0) return motion + 1;
    for (let later = line + 1; later < this.ofLine.length; later++) {
      if (this.ofLine[later] >= 0) return this.ofLine[later];
    }
    return this.count;
  }

  /** The line that a search means, from a line on: `N60`, a line's number, or a text; 0 where there is none. */
  search(wanted, from) {
    const text = wanted.trim();
    const block = /^N\s*0*(\d+)$/i.exec(text);
    if (block) {
      const number = new RegExp(`^\\s*/?\\s*N\\s*0*${block[1]}(?!\\d)`, "i");
      return this.blocks.findIndex((line) => number.test(line)) + 1;
    }
    if (/^\d+$/.test(text)) return Number(text) >= 1 && Number(text) <= this.blocks.length ? Number(text) : 0;
    if (!text) return 0;
    const low = text.toLowerCase();
    for (let step = 1; step <= this.blocks.length; step++) {
      const line = (from + step - 1) % this.blocks.length;
      if (this.blocks[line].toLowerCase().includes(low)) return line + 1;
    }
    return 0;
  }

  /** The path to be drawn: x, y, z, cursor, and the kind of the piece that ends there, −1 for none. Where in it each motion
   * begins is kept. */
  path() {
    const steps = (motion) => {
      const arc = this.arcAt[motion];
      if (arc < 0) return this.first[motion + 1] - this.first[motion];
      // As fine for a hundred turns as for one.
      return Math.max(2, Math.min(5300, Math.ceil(Math.abs(this.arcs[4 * arc + 3]) / 0.12)));
    };
    let size = 0;
    for (let motion = 0; motion < this.count; motion++) {
      size += (stands(this.kind[motion]) ? 0 : steps(motion)) + (this.jumpAt[motion] >= 0 ? 1 : 0);
    }
    const path = new Float32Array(5 * size);
    this.pieceOf = new Uint32Array(this.count + 1);
    let at = 0;
    const add = (point, cursor, kind) => {
      path[at++] = point[0]; path[at++] = point[1]; path[at++] = point[2]; path[at++] = cursor; path[at++] = kind;
    };
    for (let motion = 0; motion < this.count; motion++) {
      this.pieceOf[motion] = at / 5;
      if (this.jumpAt[motion] >= 0) add(this.startOf(motion), motion, -1);
      if (stands(this.kind[motion])) continue;
      const count = steps(motion);
      if (this.arcAt[motion] >= 0) {
        for (let step = 1; step <= count; step++) add(this.point(motion, step / count), motion + step / count, this.kind[motion]);
        continue;
      }
      for (let step = 1, point = this.first[motion]; step <= count; step++, point++) {
        const part = this.bend[motion] > 0 && step === 1 ? this.bend[motion] : step / count;
        add(this.points.subarray(3 * point, 3 * point + 3), motion + part, this.kind[motion]);
      }
    }
    return path;
  }
}
