
const MESH_VERTEX = `#version 300 es
layout(location = 0) in vec3 point;
layout(location = 1) in vec3 normal;
uniform mat4 matrix, model;
out vec3 at, out_of;
void main() {
  vec4 placed = model * vec4(point, 1.0);
  at = placed.xyz;
  out_of = mat3(model) * normal;
  gl_Position = matrix * placed;
}`;

/** A piece of outline turned about Z: the corner says which end and which angle. */
const TURNED_VERTEX = `#version 300 es
layout(location = 0) in vec2 corner;
layout(location = 1) in vec4 ends;
layout(location = 2) in vec4 normals;
uniform mat4 matrix;
out vec3 at, out_of;
void main() {
  vec2 place = mix(ends.xy, ends.zw, corner.x), normal = mix(normals.xy, normals.zw, corner.x);
  vec2 round = vec2(cos(corner.y), sin(corner.y));
  at = vec3(place.y * round, place.x);
  out_of = vec3(normal.y * round, normal.x);
  gl_Position = matrix * vec4(at, 1.0);
}`;

/** Surfaces of closed bodies; with a section the inside is shown in one colour, which looks like the cut face. */
const SURFACE_FRAGMENT = `#version 300 es
precision highp float;
in vec3 at, out_of;
uniform vec4 plane, eye, colour;
uniform vec3 cut;
uniform bool section;
out vec4 seen;
void main() {
  if (dot(plane, vec4(at, 1.0)) < 0.0) discard;
  vec3 to_eye = eye.w > 0.5 ? normalize(eye.xyz - at) : eye.xyz;
  vec3 normal = normalize(out_of);
  float facing = dot(normal, to_eye);
  if (facing < 0.0) {
    if (section && colour.a > 0.9) { seen = vec4(cut, 1.0); return; }
    facing = -facing;
    normal = -normal;
  }
  vec3 lamp = normalize(to_eye + vec3(0.35, -0.2, 0.55));
  float light = 0.34 + 0.5 * max(dot(normal, lamp), 0.0) + 0.22 * facing;
  float gloss = pow(max(dot(normal, normalize(lamp + to_eye)), 0.0), 40.0) * 0.10;
  seen = vec4(colour.rgb * light + gloss, colour.a);
}`;

const LINE_VERTEX = `#version 300 es
layout(location = 0) in vec2 corner;
layout(location = 1) in vec4 from;
layout(location = 2) in vec4 to;
layout(location = 3) in float kind;
uniform mat4 matrix;
uniform vec4 palette[12];
uniform vec2 pixels;
uniform float width, nearer;
out float cursor;
flat out vec4 colour;
void main() {
  int paint = int(kind);
  colour = paint < 0 ? vec4(0.0) : palette[paint];
  cursor = mix(from.w, to.w, corner.x);
  vec4 a = matrix * vec4(from.xyz, 1.0), b = matrix * vec4(to.xyz, 1.0);
  float least = 1e-4;
  if (paint < 0 || colour.a == 0.0 || (a.w < least && b.w < least)) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  if (a.w < least) a = mix(a, b, (least - a.w) / (b.w - a.w));
  if (b.w < least) b = mix(b, a, (least - b.w) / (a.w - b.w));
  vec2 along = (b.xy / b.w - a.xy / a.w) * pixels;
  float length = max(length(along), 1e-4);
  along /= length;
  vec4 end = mix(a, b, corner.x);
  vec2 aside = (vec2(-along.y, along.x) * corner.y + along * (corner.x - 0.5) * 0.5) * width / pixels;
  gl_Position = end + vec4(aside * end.w, -nearer * end.w, 0.0);
}`;

/** The same one pixel wide, for paths of very many pieces: a strip, each piece in the colour of its end. */
const THIN_VERTEX = `#version 300 es
layout(location = 0) in vec4 end;
layout(location = 1) in float kind;
uniform mat4 matrix;
uniform vec4 palette[12];
uniform float nearer;
out float cursor;
flat out vec4 colour;
void main() {
  int paint = int(kind);
  colour = paint < 0 ? vec4(0.0) : palette[paint];
  cursor = end.w;
  gl_Position = matrix * vec4(end.xyz, 1.0);
  gl_Position.z -= nearer * gl_Position.w;
}`;

/** More pieces than this are drawn thin. */
const THIN = 30000;

const LINE_FRAGMENT = `#version 300 es
precision highp float;
in float cursor;
flat in vec4 colour;
uniform float now, rest, strength;
out vec4 seen;
void main() {
  float share = cursor <= now ? 1.0 : rest;
  if (share * colour.a == 0.0) discard;
  seen = vec4(colour.rgb, colour.a * share * strength);
}`;

/** Draws with WebGL 2. */
class Gl {
  constructor(canvas) {
    this.canvas = canvas;
    this.gl = canvas.getContext("webgl2", { antialias: true, alpha: false });
    if (!this.gl) throw new Error("no WebGL 2");
    this.name = "webgl2";
    this.prepare();
  }

  /** What must be made again when the context comes back. */
  prepare() {
    const gl = this.gl;
    this.surface = this.program(MESH_VERTEX, SURFACE_FRAGMENT);
    this.turned = this.program(TURNED_VERTEX, SURFACE_FRAGMENT);
    this.line = this.program(LINE_VERTEX, LINE_FRAGMENT);
    this.thin = this.program(THIN_VERTEX, LINE_FRAGMENT);
    this.buffers = new Map();
    this.changing = null;
    const round = [];
    for (let at = 0; at <= 96; at++) round.push(0, (2 * Math.PI * at) / 96, 1, (2 * Math.PI * at) / 96);
    this.round = this.buffer(new Float32Array(round));
    this.quad = this.buffer(new Float32Array([0, -1, 1, -1, 0, 1, 1, 1]));
    gl.enable(gl.DEPTH_TEST);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
  }

  program(vertex, fragment) {
    const gl = this.gl, program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
      throw new Error(gl.getProgramInfoLog(program) || "a shader does not link");
    }
    const places = {};
    for (let at = 0; at < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); at++) {
      const name = gl.getActiveUniform(program, at).name.replace("[0]", "");
      places[name] = gl.getUniformLocation(program, name);
    }
    return { program, places };
  }

  buffer(data) {
    const gl = this.gl, buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    return buffer;
  }

  /** The buffer of an array that does not change. */
  kept(data) {
    let buffer = this.buffers.get(data);
    if (!buffer) this.buffers.set(data, (buffer = this.buffer(data)));
    return buffer;
  }

  /** Forgets the arrays of a program that is no longer shown. */
  forget() {
    for (const buffer of this.buffers.values()) this.gl.deleteBuffer(buffer);
    this.buffers.clear();
  }

  /** Only the first attributes are fed. */
  feeds(count) {
    for (let place = count; place < 4; place++) this.gl.disableVertexAttribArray(place);
  }

  /** Forgets one array. */
  drop(data) {
    this.gl.deleteBuffer(this.buffers.get(data));
    this.buffers.delete(data);
  }

  attribute(place, buffer, size, stride, offset, divisor) {
    const gl = this.gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, size, gl.FLOAT, false, stride, offset);
    gl.vertexAttribDivisor(place, divisor);
  }

  begin(camera, width, height, ratio) {
    const gl = this.gl;
    if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, { width, height });
    gl.viewport(0, 0, width, height);
    gl.clearColor(...light("ground"), 1);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.camera = camera.matrix(width / height);
    this.plane = camera.plane();
    this.cut = camera.section;
    this.ratio = ratio;
    this.triangles = 0;
  }

  use({ program, places }, paint, alpha) {
    const gl = this.gl;
    gl.useProgram(program);
    gl.uniformMatrix4fv(places.matrix, false, this.camera.matrix);
    gl.uniform4fv(places.plane, this.plane);
    gl.uniform4fv(places.eye, this.camera.eye);
    gl.uniform4f(places.colour, ...light(paint), alpha);
    gl.uniform3fv(places.cut, light("cut"));
    gl.uniform1i(places.section, this.cut ? 1 : 0);
    gl.depthMask(alpha === 1);
    if (alpha === 1) gl.disable(gl.BLEND);
    else gl.enable(gl.BLEND);
  }

  /** Triangles with normals; `model` stands them somewhere. */
  mesh(vertices, paint, alpha = 1, model = STILL, whole = false) {
    const gl = this.gl;
    if (vertices.length === 0) return;
    this.use(this.surface, paint, alpha);
    if (whole) gl.uniform4f(this.surface.places.plane, 0, 0, 0, 1);
    gl.uniformMatrix4fv(this.surface.places.model, false, model);
    const buffer = this.kept(vertices);
    this.attribute(0, buffer, 3, 24, 0, 0);
    this.attribute(1, buffer, 3, 24, 12, 0);
    this.feeds(2);
    gl.drawArrays(gl.TRIANGLES, 0, vertices.length / 6);
    this.triangles += vertices.length / 18;
  }

  /** Pieces of outlines turned about Z. */
  turn(pieces, paint, alpha = 1) {
    const gl = this.gl;
    if (pieces.length === 0) return;
    this.use(this.turned, paint, alpha);
    this.changing ??= gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.changing);
    gl.bufferData(gl.ARRAY_BUFFER, pieces, gl.STREAM_DRAW);
    this.attribute(0, this.round, 2, 0, 0, 0);
    this.attribute(1, this.changing, 4, 32, 0, 1);
    this.attribute(2, this.changing, 4, 32, 16, 1);
    this.feeds(3);
    // What is seen through lies a little behind what it touches.
    if (alpha < 1) gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(2, 8);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 194, pieces.length / 8);
    gl.disable(gl.POLYGON_OFFSET_FILL);
    this.triangles += (pieces.length / 8) * 192;
  }

  /** Lines of a path: `hidden` are the kinds not to be drawn, `now` the cursor, `rest` how strong the part beyond it is;
   * `first` and `most` say which pieces. */
  lines(path, { hidden = [], now = Infinity, rest = 1, width = 1.6, through = 0, first = 0, most = Infinity } = {}) {
    const gl = this.gl, count = Math.min(path.length / 5 - 1 - first, most), thin = count > THIN;
    if (count < 1) return;
    const { program, places } = thin ? this.thin : this.line;
    gl.useProgram(program);
    gl.uniformMatrix4fv(places.matrix, false, this.camera.matrix);
    const palette = LINE_COLOURS.flatMap((name, kind) => [...light(name), hidden.includes(kind) ? 0 : kind === GRID ? 0.8 : 1]);
    gl.uniform4fv(places.palette, palette);
    if (!thin) {
      gl.uniform2f(places.pixels, this.canvas.width / 2, this.canvas.height / 2);
      gl.uniform1f(places.width, (width * this.ratio) / 2);
    }
    gl.uniform1f(places.now, Math.min(now, 3e38));
    gl.uniform1f(places.rest, rest);
    gl.uniform1f(places.nearer, 2e-4);
    const buffer = this.kept(path);
    if (thin) {
      this.attribute(0, buffer, 4, 20, 20 * first, 0);
      this.attribute(1, buffer, 1, 20, 20 * first + 16, 0);
      this.feeds(2);
    } else {
      this.attribute(0, this.quad, 2, 0, 0, 0);
      this.attribute(1, buffer, 4, 20, 20 * first, 1);
      this.attribute(2, buffer, 4, 20, 20 * first + 20, 1);
      this.attribute(3, buffer, 1, 20, 20 * first + 36, 1);
    }
    const draw = () => (thin ? gl.drawArrays(gl.LINE_STRIP, 0, count + 1) : gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count));
    gl.enable(gl.BLEND);
    gl.depthMask(false);
    if (through > 0) {
      // What is behind something shines through a little.
      gl.disable(gl.DEPTH_TEST);
      gl.uniform1f(places.strength, through);
      draw();
      gl.enable(gl.DEPTH_TEST);
    }
    gl.uniform1f(places.strength, 1);
    draw();
    gl.depthMask(true);
    this.triangles += 2 * count;
  }

  end() {
    for (let place = 0; place < 4; place++) this.gl.vertexAttribDivisor(place, 0);
  }
}
