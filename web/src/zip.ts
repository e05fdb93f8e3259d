export interface ZipFile {
  name: string;
  bytes: Uint8Array;
}

const table = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});
function crc32(bytes: Uint8Array): number {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = table[(crc ^ byte) & 0xff]! ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

/** Deflated where the browser can do so and it helps, else as it is. */
async function packed(bytes: Uint8Array): Promise<{ method: 0 | 8; data: Uint8Array }> {
  try {
    const stream = new Blob([bytes]).stream().pipeThrough(new CompressionStream('deflate-raw')),
      data = new Uint8Array(await new Response(stream).arrayBuffer());
    if (data.length < bytes.length) return { method: 8, data };
  } catch {
    // an older browser
  }
  return { method: 0, data: bytes };
}

const stored = { utf8: 0x0800, version: 20, firstDay: 0x21 }; // 1980-01-01, as in archives of `planish pack`

/** Files as one archive, in this order; their names are UTF-8. */
export async function zip(files: ZipFile[]): Promise<Blob> {
  const parts: Uint8Array[] = [],
    directory: Uint8Array[] = [];
  let at = 0;
  for (const { name, bytes } of files) {
    const { method, data } = await packed(bytes),
      called = new TextEncoder().encode(name);
    const common = [
      [stored.version, 2],
      [stored.utf8, 2],
      [method, 2],
      [0, 2],
      [stored.firstDay, 2],
      [crc32(bytes), 4],
      [data.length, 4],
      [bytes.length, 4],
      [called.length, 2],
      [0, 2],
    ] as const;
    const local = record([[0x04034b50, 4], ...common]);
    directory.push(
      record([[0x02014b50, 4], [stored.version, 2], ...common, [0, 2], [0, 2], [0, 2], [0, 4], [at, 4]]),
      called,
    );
    parts.push(local, called, data);
    at += local.length + called.length + data.length;
  }
  const size = directory.reduce((sum, d) => sum + d.length, 0),
    count = files.length;
  const end = record([
    [0x06054b50, 4],
    [0, 2],
    [0, 2],
    [count, 2],
    [count, 2],
    [size, 4],
    [at, 4],
    [0, 2],
  ]);
  return new Blob([...parts, ...directory, end], { type: 'application/zip' });
}

/** Little-endian numbers of so many bytes. */
function record(fields: readonly (readonly [number, 2 | 4])[]): Uint8Array {
  const bytes = new Uint8Array(fields.reduce((sum, [, size]) => sum + size, 0)),
    view = new DataView(bytes.buffer);
  let at = 0;
  for (const [value, size] of fields) {
    if (size === 2) view.setUint16(at, value, true);
    else view.setUint32(at, value, true);
    at += size;
  }
  return bytes;
}
