import { reduce } from './reduce.ts';
import type { Action, State } from './state.ts';

export type Listener = (state: State, before: State) => void;

export class Store {
  state: State;
  private readonly listeners: Listener[] = [];
  constructor(state: State) {
    this.state = state;
  }
  subscribe(listener: Listener) {
    this.listeners.push(listener);
  }
  dispatch = (action: Action) => {
    const before = this.state;
    this.state = reduce(before, action);
    if (this.state !== before) for (const listener of this.listeners) listener(this.state, before);
  };
}
