// Loaded before the tests: what every browser has, and Node 18, which Debian 12 comes with, lacks.
import { webcrypto } from 'node:crypto';

globalThis.crypto ??= webcrypto;
