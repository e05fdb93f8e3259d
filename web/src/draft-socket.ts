import type { ApiProblem } from './types.ts';

/** A shape's bytes, a problem, or null where the connection was lost. */
export type DraftAnswer = ArrayBuffer | (ApiProblem & { status: number }) | null;

const patience = 5000; // ms before a connection that was lost is tried again

/**
 * A WebSocket over which drafts are asked for: faster than HTTP, without which everything works as well. Answers come
 * in the order of what was asked.
 */
export class DraftSocket {
  private socket: WebSocket | null = null;
  private waiting: ((answer: DraftAnswer) => void)[] = [];
  private triedAt = -Infinity;

  private readonly address: () => Promise<string>;
  constructor(address: () => Promise<string>) {
    this.address = address;
  }

  /** Null where there is no connection; then one is made for the next time. */
  ask(id: string, request: string): Promise<DraftAnswer> | null {
    const { socket } = this;
    if (socket?.readyState !== WebSocket.OPEN) {
      void this.connect();
      return null;
    }
    return new Promise((answered) => {
      this.waiting.push(answered);
      socket.send(`${id}\n${request}`);
    });
  }

  private async connect() {
    if (this.socket || performance.now() - this.triedAt < patience) return;
    this.triedAt = performance.now();
    const address = await this.address().catch(() => null);
    if (!address) return;
    const socket = new WebSocket(address);
    let opened = false;
    this.socket = socket;
    socket.binaryType = 'arraybuffer';
    socket.addEventListener('message', ({ data }: MessageEvent<ArrayBuffer | string>) =>
      this.waiting.shift()?.(typeof data === 'string' ? (JSON.parse(data) as DraftAnswer) : data),
    );
    socket.addEventListener('open', () => {
      opened = true;
    });
    socket.addEventListener('close', () => {
      this.socket = null;
      if (!opened) this.triedAt = Infinity; // of another machine, say, of which one port alone is passed on: not again
      this.waiting.splice(0).forEach((answered) => answered(null));
    });
  }
}
