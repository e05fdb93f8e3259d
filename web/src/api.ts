import { decodeShape } from './shape.ts';
import type { ApiProblem, Description, Example, OpenDocument, OrderAnswer, Progress, Request, Shape } from './types.ts';

/** An error, as worded by the program. */
export class ApiError extends Error {
  readonly problem: ApiProblem;
  readonly status: number;
  constructor(problem: ApiProblem, status: number) {
    super(problem.message);
    this.problem = problem;
    this.status = status;
  }
}

type More = Pick<RequestInit, 'keepalive' | 'signal'>;

export class Api {
  private readonly token: string;
  private readonly keeping = new Map<string, Promise<unknown>>(); // by name
  constructor(token: string) {
    this.token = token;
  }

  description = () => this.json<Description>('GET', '/api/description');
  examples = () => this.json<Example[]>('GET', '/api/examples');
  example = async (name: string) =>
    (await this.call('GET', `/api/examples/${name.split('/').map(encodeURIComponent).join('/')}`)).arrayBuffer();
  documents = () => this.json<OpenDocument[]>('GET', '/api/documents');
  /** A document that is not read yet; `open` reads it. */
  create = (name: string, bytes: ArrayBuffer | Blob) =>
    this.json<{ id: string; name: string }>('POST', `/api/documents?name=${encodeURIComponent(name)}`, bytes);
  open = (id: string, signal?: AbortSignal) =>
    this.json<OpenDocument>('POST', `/api/documents/${id}/open`, undefined, { signal });
  attach = (id: string, name: string, bytes: ArrayBuffer | Blob) =>
    this.call('PUT', `/api/documents/${id}/attachments/${encodeURIComponent(name)}`, bytes);
  close = (id: string) => this.call('DELETE', `/api/documents/${id}`, undefined, { keepalive: true });
  draft = (id: string, request: Request, signal?: AbortSignal) => this.shape(id, 'draft', request, signal);
  result = (id: string, request: Request, signal?: AbortSignal) => this.shape(id, 'result', request, signal);
  plan = (id: string, request: Request, signal?: AbortSignal) =>
    this.json<OrderAnswer>('POST', `/api/documents/${id}/plan`, JSON.stringify(request), { signal });
  file = async (id: string, artifact: string, request: Request, signal?: AbortSignal) =>
    (await this.call('POST', `/api/documents/${id}/files/${artifact}`, JSON.stringify(request), { signal })).blob();
  progress = (id: string) => this.json<Progress | null>('GET', `/api/documents/${id}/progress`);
  /** What is kept on this machine from one start to the next. */
  kept = async (name: string) => (await this.call('GET', `/api/kept/${encodeURIComponent(name)}`)).arrayBuffer();
  keptNames = () => this.json<{ name: string; size: number }[]>('GET', '/api/kept');
  keep = (name: string, content: Blob) => {
    // What is small is kept even if the page is left now; of two contents the later one stays.
    const path = `/api/kept/${encodeURIComponent(name)}`,
      put = (keepalive: boolean) => this.call('PUT', path, content, { keepalive });
    // Browsers let 64 KiB at a time outlive their page, and fail what is above.
    const again = (error: unknown) => {
      if (error instanceof ApiError && error.status === 0) return put(false);
      throw error; // the server has said why not
    };
    const write = () => (content.size < 30_000 ? put(true).catch(again) : put(false));
    const earlier = this.keeping.get(name),
      written = earlier ? earlier.then(write, write) : write();
    this.keeping.set(name, written);
    return written;
  };
  forget = (name: string) => this.call('DELETE', `/api/kept/${encodeURIComponent(name)}`);
  /** An answer that lasts as long as the page, so that the server knows of it. False: it need not know. */
  stay = async (): Promise<boolean> => {
    const answer = await this.call('GET', '/api/presence');
    const reader = answer.body?.getReader();
    while (reader && !(await reader.read()).done);
    return answer.status !== 204;
  };
  cancel = (id: string) => this.call('POST', `/api/documents/${id}/cancel`);

  private async shape(id: string, what: string, request: Request, signal?: AbortSignal): Promise<Shape> {
    const answer = await this.call('POST', `/api/documents/${id}/${what}`, JSON.stringify(request), { signal });
    return decodeShape(await answer.arrayBuffer());
  }

  private async json<T>(method: string, path: string, body?: BodyInit, more?: More): Promise<T> {
    return (await (await this.call(method, path, body, more)).json()) as T;
  }

  private async call(method: string, path: string, body?: BodyInit, more: More = {}): Promise<Response> {
    const headers: Record<string, string> = { 'X-Planish-Token': this.token };
    if (body !== undefined)
      headers['Content-Type'] = typeof body === 'string' ? 'application/json' : 'application/octet-stream';
    let answer: Response;
    try {
      answer = await fetch(path, { method, headers, body, cache: 'no-store', ...more });
    } catch {
      if (more.signal?.aborted) throw cancelled();
      throw new ApiError(
        { code: 'no_server', message: 'the studio’s server does not answer; is planish studio still running?' },
        0,
      );
    }
    if (!answer.ok) throw new ApiError(await problemOf(answer), answer.status);
    // A complaint about invalid input is an ordinary answer; for an error status the browser would log a failure.
    if (answer.headers.get('Content-Type')?.startsWith('application/problem+json'))
      throw new ApiError(await problemOf(answer), 422);
    return answer;
  }
}

const cancelled = () => new ApiError({ code: 'cancelled', message: 'cancelled' }, 0);

/** What an answer complains about, with all its data. */
export async function problemOf(answer: Response): Promise<ApiProblem> {
  try {
    const body = (await answer.json()) as Partial<ApiProblem>;
    if (typeof body.message === 'string')
      return { ...body, code: body.code ?? String(answer.status), message: body.message };
  } catch {
    /* not JSON: said below */
  }
  if (answer.status === 403)
    return {
      code: 'forbidden',
      message: 'the page lacks the token of this server; open the address that planish studio printed',
    };
  return { code: String(answer.status), message: `the server answered ${answer.status} ${answer.statusText}` };
}
