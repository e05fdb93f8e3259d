import { noOrder, type Answered, type OrderState } from './order-state.ts';
import type { History, Input, State } from './state.ts';
import type { BrakeOptions } from './types.ts';

/** The order of strokes, with those that undo and redo go through, as a tab keeps them for a reload. */
interface KeptOrder {
  of: number | null; // how far the input that was ordered lies ahead of the one that is shown, in steps of redo
  brakes: BrakeOptions[]; // each once: they may hold files of tools
  brake: number;
  now: KeptAnswer;
  past: KeptAnswer[];
  future: KeptAnswer[];
}
type KeptAnswer = Omit<Answered, 'ofBrake'> & { ofBrake: number };

/**
 * The text that restores the order of an input, `steps` of those before and after it with it; null: there is nothing
 * to be kept.
 */
export function textOfOrder({ order, input, past, future }: State, steps: number): string | null {
  if (!order.answer && order.brake === noOrder.brake) return null;
  const brakes: BrakeOptions[] = [];
  const numbered = (brake: BrakeOptions | null) => {
    if (brake === null) return -1;
    if (!brakes.includes(brake)) brakes.push(brake);
    return brakes.indexOf(brake);
  };
  const kept = ({ answer, ofBrake, given }: Answered): KeptAnswer => ({ answer, given, ofBrake: numbered(ofBrake) });
  const all = [...past, input, ...future],
    at = order.of ? all.indexOf(order.of) : -1;
  const own: KeptOrder = {
    of: at < 0 ? null : at - past.length,
    brake: numbered(order.brake),
    now: kept(order),
    past: steps > 0 ? order.past.slice(-steps).map(kept) : [],
    future: order.future.slice(0, steps).map(kept),
    brakes,
  };
  return JSON.stringify(own);
}

/** What was kept of the order, for an input that was kept with it. */
export function orderOfText(text: string, { input, past, future }: History): OrderState {
  const own = JSON.parse(text) as KeptOrder;
  const answered = ({ answer, ofBrake, given }: KeptAnswer): Answered => ({
    answer,
    given,
    ofBrake: own.brakes[ofBrake] ?? null,
  });
  const of: Input | undefined = own.of === null ? undefined : [...past, input, ...future][past.length + own.of];
  return {
    ...noOrder,
    ...answered(own.now),
    brake: own.brakes[own.brake] ?? noOrder.brake,
    of: of ?? null,
    past: of ? own.past.map(answered) : [],
    future: of ? own.future.map(answered) : [],
  };
}
