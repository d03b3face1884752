// The real programs for a browser: the simulator with its page, and the three programs of the box.
import {spawn} from 'node:child_process';
import {existsSync, mkdtempSync, openSync, closeSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {end, until} from '../hw-sim/browser/harness.mjs';

const kPrograms = process.env.KAORI_PROGRAMS;
const kShows = join(kPrograms, '..', 'shows');
const kBoxPrograms = ['kaori-input', 'kaori-lips', 'kaori-stage'];

export class BoxSystem {
  // `options` are further ones, by the program. `size` is that of the screen. A machine without a GPU draws the usual one four times as often as that of a demo.
  constructor({size = '480x270', options = {}} = {}) {
    this.size = size;
    this.options = options;
    this.folder = mkdtempSync(join(tmpdir(), 'kaori-browser-'));
    this.running = new Map();
    this.port = '0';
    this.start('kaori-sim');
    kBoxPrograms.forEach((program) => this.start(program));
  }

  file(name) {
    return join(this.folder, name);
  }

  optionsOf(program) {
    const links = ['--links', this.file('links')];
    const board = ['--board', this.file('board')];
    switch (program) {
      case 'kaori-sim':
        return [...links, '--size', this.size, '--board', this.file('board'), '--hz', '30', '--console', this.port, '--address-file', this.file('address'),
                '--labels', join(kShows, 'kaori.labels.json')];
      case 'kaori-stage': return [...links, ...board, '--pack', join(kShows, 'kaori.kaori')];
      default: return [...links, ...board];
    }
  }

  start(program) {
    const log = openSync(this.file(`${program}.log`), 'a');
    const options = [...this.optionsOf(program), ...this.options[program] ?? []];
    this.running.set(program, spawn(join(kPrograms, program), options, {
      stdio: ['ignore', log, log],
      env: {...process.env, XDG_STATE_HOME: this.folder},  // Nobody's own expressions.
    }));
    closeSync(log);
  }

  async kill(program) {
    const child = this.running.get(program);
    this.running.delete(program);
    await end(child, 'SIGKILL');
  }

  async address() {
    const file = this.file('address');
    const address = await until('the address of the page', () => existsSync(file) && readFileSync(file, 'utf8').trim());
    this.port = new URL(address).port;  // A simulator that is started again keeps it.
    return address;
  }

  async state() {
    return (await fetch(new URL('state', await this.address()))).json();
  }

  // What the programs said, for a failure's report.
  logs() {
    return ['kaori-sim', ...kBoxPrograms].map((program) => readFileSync(this.file(`${program}.log`), 'utf8')).join('');
  }

  async close() {
    for (const program of [...this.running.keys()]) await this.kill(program);
    rmSync(this.folder, {recursive: true, force: true});
  }
}
