/**
 * The wire format: a JSON header and one binary buffer. A header refers to the buffer by byte
 * offsets; floats and integers are little-endian. What is not as it should be raises here, before
 * the scene is touched. The other end of this module is `wire.py`.
 */
const FORMAT = 1;

/** Header and buffer of a snapshot: the header's length, the header, padding to 8, the buffer. */
export function splitSnapshot(view) {
  const bytes = new Uint8Array(view.buffer, view.byteOffset, view.byteLength);
  if (bytes.length < 4) throw new Error("a snapshot needs at least 4 bytes");
  const length = new DataView(view.buffer, view.byteOffset).getUint32(0, true);
  if (4 + length > bytes.length) throw new Error("a snapshot is shorter than its header");
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  return [header, bytes.subarray(Math.min(8 * Math.ceil((4 + length) / 8), bytes.length))];
}

/** A batch of changes, every array in it checked for its place, its size and its numbers. */
export function decode(header, view) {
  if (header.format !== FORMAT) throw new Error(`wire format ${header.format} is not ${FORMAT}`);
  const read = reader(view);
  const styles = list(header.styles, "styles").map(checkedStyle);
  const [puts, paints, curves] = ["puts", "paints", "curves"].map((what) => list(header[what], what));
  return {
    sequence: natural(header.seq, "seq"),
    fresh: Boolean(header.fresh),
    play: list(header.play, "play"),
    geometry: new Map(
      Object.entries(header.geometry ?? {}).map(([key, form]) => [key, decodeShape(form, read)]),
    ),
    clocks: new Map(
      Object.entries(header.clocks ?? {}).map(([key, form]) => [key, decodeTimes(form, read)]),
    ),
    rests: new Map(Object.entries(header.rests ?? {}).map(([key, form]) => [key, decodeRest(form)])),
    removes: list(header.removes, "removes").map((id) => natural(id, "node")),
    puts: puts.map((put) => decodePut(put, read, styles)),
    joints: decodeJoints(header.joints, read),
    poses: decodePoses(header.poses, read),
    paints: paints.map(([id, style, visible]) => ({
      id: natural(id, "node"),
      style: known(styles[style], "style"),
      visible: Boolean(visible),
    })),
    curves: curves.map(([id, form]) => ({
      id: natural(id, "node"),
      curve: form && decodeCurve(form, read),
    })),
  };
}

function reader(view) {
  const bytes = view
    ? new Uint8Array(view.buffer, view.byteOffset, view.byteLength).slice()
    : new Uint8Array(0);
  return (Type, offset, length) => {
    natural(offset, "offset");
    natural(length, "length");
    const size = Type.BYTES_PER_ELEMENT;
    if (offset % size || offset + length * size > bytes.length) {
      throw new Error(`${length} numbers at byte ${offset} do not fit a buffer of ${bytes.length}`);
    }
    const numbers = new Type(bytes.buffer, offset, length);
    if (!numbers.every(Number.isFinite)) throw new Error("a number is not finite");
    return numbers;
  };
}

function natural(value, what) {
  if (Number.isSafeInteger(value) && value >= 0) return value;
  throw new Error(`${what} must be a whole number from 0 up, got ${JSON.stringify(value)}`);
}

function list(value, what) {
  if (Array.isArray(value ?? [])) return value ?? [];
  throw new Error(`${what} must be a list, got ${JSON.stringify(value)}`);
}

function text(value, what) {
  if (typeof value === "string" && value !== "") return value;
  throw new Error(`${what} must be a text, got ${JSON.stringify(value)}`);
}

function known(value, what) {
  if (value === undefined || value === null) throw new Error(`${what} is unknown`);
  return value;
}

function finite(value, what) {
  if (typeof value === "number" && Number.isFinite(value)) return value;
  throw new Error(`${what} must be a finite number, got ${JSON.stringify(value)}`);
}

function checkedStyle(style) {
  const colors = (style.edge_color ?? null) === null ? [style.color] : [style.color, style.edge_color];
  for (const color of colors) {
    if (!Array.isArray(color) || color.length !== 3) throw new Error("a colour has 3 numbers");
    color.forEach((part) => finite(part, "a colour"));
  }
  finite(style.opacity, "opacity");
  finite(style.line_width, "line_width");
  return style;
}

function decodePut(put, read, styles) {
  return {
    id: natural(put.id, "node"),
    path: text(put.path, "path"),
    pose: new Float64Array(read(Float64Array, put.pose, 12)),
    joint: put.joint ? decodeJoint(put.joint) : null,
    value: finite(put.value ?? 0, "value"),
    shape: put.shape ?? null,
    style: known(styles[put.style], "style"),
    visible: put.visible ?? true,
    curve: put.curve ? decodeCurve(put.curve, read) : null,
    span: put.span ? decodeSpan(put.span) : null,
    gauge: put.gauge ? decodeGauge(put.gauge) : null,
  };
}

function decodeGauge({ kind, key, value, size, text }) {
  checkKind(kind);
  return { kind, key: String(key), value: finite(value, "value"), size: finite(size, "size"), text: String(text) };
}

function checkKind(kind) {
  if (kind !== "r" && kind !== "p") throw new Error(`no joint kind '${kind}'; use 'r' or 'p'`);
}

function decodeJoint({ kind, key, after }) {
  checkKind(kind);
  if (!after) return { kind, key: String(key), after: null };
  if (after.length !== 12) throw new Error("a pose has 12 numbers");
  after.forEach((part) => finite(part, "a pose"));
  return { kind, key: String(key), after: Float64Array.from(after) };
}

function decodeJoints(form, read) {
  if (!form) return { ids: [], values: [] };
  const count = natural(form.count, "count");
  return {
    ids: read(Uint32Array, form.ids, count),
    values: read(Float64Array, form.values, count),
  };
}

function decodePoses(form, read) {
  if (!form) return { ids: [], poses: [] };
  const count = natural(form.count, "count");
  const matrices = Float64Array.from(read(Float32Array, form.matrices, 12 * count));
  const poses = Array.from({ length: count }, (_, i) => matrices.subarray(12 * i, 12 * i + 12));
  return { ids: read(Uint32Array, form.ids, count), poses };
}

function decodeTimes({ at, count, stops: given }, read) {
  const stops = list(given, "stops");
  const times = read(Float64Array, at, count);
  if (count < 1) throw new Error("a clock has at least one instant");
  for (let i = 1; i < count; i++) {
    if (times[i] <= times[i - 1]) throw new Error("the instants of a clock must increase");
  }
  const held = (stop) => finite(stop, "a stop") >= times[0] && stop <= times[count - 1];
  if (!stops.every((stop, k) => held(stop) && (k === 0 || stop >= stops[k - 1]))) {
    throw new Error("the stops of a clock must be in order and within its instants");
  }
  return Object.assign(times, { stops });
}

function decodeRest([time, turn]) {
  return { time: finite(time, "a rest"), turn: natural(turn, "a turn") };
}

function decodeSpan({ clock, begin, end, grown }) {
  return {
    clock: String(clock),
    begin: finite(begin, "the begin of a span"),
    end: end === undefined ? Infinity : finite(end, "the end of a span"),
    grown: grown === undefined ? -Infinity : finite(grown, "a span"),
  };
}

function decodeCurve({ clock, at, count, width }, read) {
  natural(count, "count");
  if (width !== 1 && width !== 12) throw new Error("a sample has 1 or 12 numbers");
  const samples =
    width === 1
      ? read(Float64Array, at, count)
      : Float64Array.from(read(Float32Array, at, 12 * count));
  return { clock: String(clock), samples, count, width };
}

function decodeShape(form, read) {
  switch (form.kind) {
    case "mesh":
      return decodeMesh(form, read);
    case "lines":
      return { kind: "lines", segments: read(Float32Array, form.segments, 6 * natural(form.count, "count")) };
    case "label":
      return { kind: "label", text: String(form.text), size: finite(form.size, "size") };
    default:
      throw new Error(`no shape '${form.kind}'; use mesh, lines or label`);
  }
}

function decodeMesh(form, read) {
  const [triangles, vertices, segments] = ["triangles", "vertices", "segments"].map((what) =>
    natural(form[what], what),
  );
  const indices = read(Uint32Array, form.indices, 3 * triangles);
  if (indices.some((index) => index >= vertices)) throw new Error("a face names no vertex");
  return {
    kind: "mesh",
    positions: read(Float32Array, form.positions, 3 * vertices),
    normals: read(Float32Array, form.normals, 3 * vertices),
    indices,
    edges: read(Float32Array, form.edges, 6 * segments),
  };
}
