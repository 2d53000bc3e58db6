/**
 * A scene as a snapshot, as Python would send it: what a saved notebook keeps. The format is that
 * of `wire.py` and `wire.js`.
 */
const FORMAT = 1;

/** The whole scene in one piece: joints as they are shown, planned motions at their end. */
export function encode(scene) {
  const pack = new Pack();
  const styles = [];
  const puts = [...scene.nodes.values()].map((node) => encodePut(node, pack, styles));
  const geometry = new Map();
  for (const { digest, shape } of scene.nodes.values()) {
    if (digest !== null && !geometry.has(digest)) geometry.set(digest, encodeShape(shape, pack));
  }
  const clocks = scene.players.map(({ key, times }) => [
    key,
    {
      count: times.length,
      at: pack.add(Float64Array, times),
      ...(times.stops?.length && { stops: times.stops }),
    },
  ]);
  const rests = scene.players.filter(({ stops }) => stops.length).map((player) => [
    player.key,
    [player.stops[player.at], player.turn],
  ]);
  const header = {
    kind: "batch",
    format: FORMAT,
    seq: scene.sequence,
    fresh: true,
    play: [],
    puts,
    styles,
    geometry: Object.fromEntries(geometry),
    clocks: Object.fromEntries(clocks),
    rests: Object.fromEntries(rests),
  };
  return join(new TextEncoder().encode(JSON.stringify(header)), pack);
}

/** Arrays one behind the other, each from a multiple of 8 bytes on. */
class Pack {
  chunks = [];
  size = 0;

  /** Append numbers; returns the offset where they begin. */
  add(Type, numbers) {
    const at = this.size;
    const chunk = new Uint8Array(Type.from(numbers).buffer);
    this.chunks.push([at, chunk]);
    this.size += padded(chunk.length);
    return at;
  }
}

function encodePut(node, pack, styles) {
  const { id, path, pose, joint, digest, style, visible, curve, span, gauge, shown } = node;
  return {
    id,
    path,
    pose: pack.add(Float64Array, pose),
    style: numberOf(style, styles),
    ...(joint && { joint: { ...joint, after: joint.after && [...joint.after] } }),
    ...(joint && { value: curve ? node.value : shown.value }),
    ...(digest !== null && { shape: digest }),
    ...(!visible && { visible }),
    ...(curve && { curve: encodeCurve(curve, pack) }),
    ...(span && { span: encodeSpan(span) }),
    ...(gauge && { gauge }),
  };
}

/** Styles of one message are one object each, those of another message are others. */
function numberOf(style, styles) {
  const known = styles.indexOf(style);
  return known < 0 ? styles.push(style) - 1 : known;
}

function encodeCurve({ clock, samples, count, width }, pack) {
  return { clock, count, width, at: pack.add(width === 12 ? Float32Array : Float64Array, samples) };
}

/** JSON has no infinite numbers: what is not there has no bound. */
function encodeSpan({ clock, begin, end, grown }) {
  return {
    clock,
    begin,
    ...(end < Infinity && { end }),
    ...(grown > begin && { grown }),
  };
}

function encodeShape(shape, pack) {
  if (shape.kind === "label") return { kind: "label", text: shape.text, size: shape.size };
  if (shape.kind === "lines") {
    const { segments } = shape;
    return { kind: "lines", count: segments.length / 6, segments: pack.add(Float32Array, segments) };
  }
  const { positions, normals, indices, edges } = shape;
  return {
    kind: "mesh",
    vertices: positions.length / 3,
    positions: pack.add(Float32Array, positions),
    normals: pack.add(Float32Array, normals),
    triangles: indices.length / 3,
    indices: pack.add(Uint32Array, indices),
    segments: edges.length / 6,
    edges: pack.add(Float32Array, edges),
  };
}

function join(text, { chunks, size }) {
  const start = padded(4 + text.length);
  const bytes = new Uint8Array(start + size);
  new DataView(bytes.buffer).setUint32(0, text.length, true);
  bytes.set(text, 4);
  for (const [at, chunk] of chunks) bytes.set(chunk, start + at);
  return new DataView(bytes.buffer);
}

function padded(length) {
  return 8 * Math.ceil(length / 8);
}
