import type { Api } from './api.ts';
import { optionsOf, refused, sameOptions, type BodyStatus } from './bodies.ts';
import { hasPattern, stems, summaryCsv } from './body-files.ts';
import { problemOf } from './compute.ts';
import { dxfOptions } from './dxf-choices.ts';
import { bodyOf, makerOf } from './state.ts';
import type { Store } from './store.ts';
import { saysWhy } from './survey.ts';
import type { ApiProblem, BodyInfo, LengthUnit, OpenDocument, Options, Report } from './types.ts';
import { zip, type ZipFile } from './zip.ts';

/** The DXF of every body that is a sheet, with a summary, as one ZIP: what `planish unfold --all` writes. */
export class Archive {
  private cancelled = false;
  private flight = new AbortController(); // of the request that is running

  private readonly api: Api;
  private readonly store: Store;
  private readonly save: (blob: Blob, name: string) => void;
  constructor(api: Api, store: Store, save: (blob: Blob, name: string) => void) {
    this.api = api;
    this.store = store;
    this.save = save;
  }

  cancel() {
    this.cancelled = true;
    const { document, archive } = this.store.state;
    if (!document || !archive) return;
    void this.api.cancel(document.id).catch(() => undefined);
    this.flight.abort(); // its answer would be logged as a failure
  }

  async start() {
    const { document, archive } = this.store.state;
    if (archive || !document?.info) return;
    this.cancelled = false;
    this.flight = new AbortController();
    try {
      const files = await this.filesOf(document, document.info.bodies);
      if (files) this.save(await zip(files), `${document.name.replace(/\.[^.]*$/, '')}.zip`);
      this.store.dispatch({ type: 'note', note: files ? said(files.length - 1) : 'cancelled' });
    } catch (error) {
      this.store.dispatch(
        this.cancelled ? { type: 'note', note: 'cancelled' } : { type: 'problem', problem: problemOf(error) },
      );
    }
    this.store.dispatch({ type: 'archive', archive: null });
  }

  /** Null if it was cancelled, or another file was opened. */
  private async filesOf(document: OpenDocument, bodies: BodyInfo[]): Promise<ZipFile[] | null> {
    const { state } = this.store,
      maker = makerOf({ ...state, document }),
      dxf = maker ? dxfOptions(state.workshop.dxf, maker, state.units) : {},
      shown = bodyOf(state),
      reports: Report[] = [],
      pierced: (number | null)[] = [],
      drawings: (Uint8Array | null)[] = [];
    for (const body of bodies) {
      this.store.dispatch({ type: 'archive', archive: { done: reports.length, all: bodies.length } });
      const own = optionsOf(state.input, body.number, shown),
        { report, drawing } = await this.make(document, body, own, dxf),
        pierces = drawing ? await this.piercesOf(document, body, own) : null;
      if (this.cancelled || this.store.state.document?.id !== document.id) return null;
      reports.push(report);
      pierced.push(pierces);
      drawings.push(drawing);
      this.store.dispatch({
        type: 'body',
        id: document.id,
        number: body.number,
        status: this.known(body, report, own),
      });
    }
    const names = stems(reports).map((stem) => (stem ? `${stem}.dxf` : '')),
      summary = summaryCsv(
        reports.map((report, i) => ({ report, pierces: pierced[i]!, files: drawings[i] ? [names[i]!] : [] })),
      );
    return [
      ...drawings.flatMap((bytes, i) => (bytes ? [{ name: names[i]!, bytes }] : [])),
      { name: 'summary.csv', bytes: new TextEncoder().encode(summary) },
    ];
  }

  private async make(document: OpenDocument, body: BodyInfo, own: Options, dxf: Options) {
    const options = { ...own, ...dxf, body: body.number },
      bytes = async (artifact: string) =>
        new Uint8Array(
          await (await this.api.file(document.id, artifact, { options }, this.flight.signal)).arrayBuffer(),
        );
    try {
      const report = JSON.parse(new TextDecoder().decode(await bytes('json'))) as Report;
      return { report, drawing: hasPattern(report) ? await bytes('dxf') : null };
    } catch (error) {
      if (this.cancelled || !saysWhy(error)) throw error;
      return { report: failed(document, body, problemOf(error), dxf.units ?? 'mm'), drawing: null };
    }
  }

  /** As the list knows it already, or by a draft. */
  private async piercesOf(document: OpenDocument, { number }: BodyInfo, own: Options): Promise<number | null> {
    const known = this.store.state.bodies[number];
    if (known?.pierces !== undefined && sameOptions(known.of, own)) return known.pierces;
    return (await this.api.draft(document.id, { options: { ...own, body: number } }, this.flight.signal)).pierces;
  }

  /** What the list says of a body: its report has no picture. */
  private known(body: BodyInfo, report: Report, of: Options): BodyStatus {
    const before = this.store.state.bodies[body.number];
    if (report.status === 'refused')
      return {
        ...refused(report.reason ?? { code: 'refused', message: 'it was refused' }, of),
        ...(before?.picture ? { picture: before.picture } : {}),
      };
    return {
      ...(before ?? { of }),
      status: report.status,
      units: report.units,
      thickness: report.sheet?.thickness,
      size: report.flat?.size,
    };
  }
}

const said = (count: number) => `${count} DXF file${count === 1 ? '' : 's'} and a summary are in the archive.`;

/** The report of a body on which the work ended. */
const failed = (document: OpenDocument, body: BodyInfo, reason: ApiProblem, units: LengthUnit): Report => ({
  format: 'planish/report',
  version: 1,
  command: document.kind as Report['command'],
  input: document.name,
  body: body.name,
  body_number: body.number,
  quantity: body.quantity,
  units,
  status: 'refused',
  reason: { where: document.name, places: [], numbers: {}, ...reason },
  sheet: null,
  flat: null,
  verification: null,
  checks: [],
  notes: [],
  files: [],
});
