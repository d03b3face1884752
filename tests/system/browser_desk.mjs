// The harness of the desk's browser tests: desk-harness, an operator with green lips, and a visitor's browser.
import {spawn} from 'node:child_process';
import {mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir, userInfo} from 'node:os';
import {join} from 'node:path';
import {createInterface} from 'node:readline';

import {end, until} from '../hw-sim/browser/harness.mjs';

export class DeskHarness {
  constructor() {
    this.folder = mkdtempSync(join(tmpdir(), 'kaori-desk-'));
    this.process = spawn(join(process.env.KAORI_PROGRAMS, 'desk-harness'), [this.folder], {stdio: ['pipe', 'pipe', 'pipe']});
    this.lines = [];
    this.log = '';
    this.process.stderr.on('data', (text) => { this.log += text; });
    createInterface({input: this.process.stdout}).on('line', (line) => this.lines.push(line));
  }

  said(kind) {
    return this.lines.findLast((line) => line.startsWith(`${kind} `))?.slice(kind.length + 1);
  }
  address() {
    return until('the address of the page', () => this.said('address'));
  }
  code() {
    return until('a code', () => this.said('code'));
  }
  tell(line) {
    this.process.stdin.write(`${line}\n`);
  }
  settings() {
    return readFileSync(join(this.folder, 'lips.settings'), 'utf8');
  }

  // The real kaori-shows, with the service key on: a box in a folder, and another one in the place of its stick.
  startShows(files) {
    for (const folder of ['data/settings', 'data/shows', 'stick', 'keys', 'report']) mkdirSync(join(this.folder, folder), {recursive: true});
    for (const [name, text] of Object.entries({...files, open: ''})) writeFileSync(join(this.folder, name), text);
    const at = (name) => join(this.folder, name);
    const {username} = userInfo();
    this.shows = spawn(join(process.env.KAORI_PROGRAMS, 'kaori-shows'), [
      '--board', at('board'), '--open', at('open'), '--shows', at('data/shows'), '--keys', at('data/settings/keys'), '--root-keys', at('keys'),
      '--report', at('report'), '--stick', at('stick'), '--plugged', '--trial-user', username, '--desk-user', username,
    ], {stdio: ['ignore', 'ignore', 'pipe']});
    this.shows.stderr.on('data', (text) => { this.log += text; });
  }
  file(name) {
    return readFileSync(join(this.folder, name), 'utf8');
  }
  write(name, text) {
    writeFileSync(join(this.folder, name), text);
  }
  // As when the service key is turned back.
  async turnKeyBack() {
    rmSync(join(this.folder, 'open'));
    await until('the end of kaori-shows', () => this.shows.exitCode !== null);
  }

  async close() {
    if (this.shows?.exitCode === null) await end(this.shows, 'SIGTERM');
    await end(this.process, 'SIGTERM');
    rmSync(this.folder, {recursive: true, force: true});
  }
}

// A visitor who accepts the box's own certificate. Every request is noted.
export async function visit(browser, address, options = {viewport: {width: 1280, height: 800}, locale: 'en-GB'}) {
  const context = await browser.newContext({...options, ignoreHTTPSErrors: true});
  const page = await context.newPage();
  page.faults = [];
  page.asked = [];
  page.bytes = 0;
  page.on('pageerror', (error) => page.faults.push(error.message));
  page.on('request', (request) => page.asked.push(request.url()));
  page.on('response', async (response) => {
    const endless = ['text/event-stream', 'multipart/'].some((type) => response.headers()['content-type']?.startsWith(type));
    const body = endless ? '' : await response.body().catch(() => '');
    page.bytes += body.length;
  });
  await page.goto(address);
  await until('a page that knows where it stands', () => page.evaluate(() => document.body.dataset.view !== 'wait'));
  return page;
}

export async function pair(page, harness) {
  await page.locator('#code').fill(await harness.code());
  await page.locator('#pair button').click();
  await until('a desk that is open', () => page.locator('#desk').isVisible());
  await until('a live picture', () => page.evaluate(() => document.querySelector('#picture').naturalWidth > 0));
}

export const stateOf = (page) => page.evaluate(async () => (await fetch('/state')).json());

// The part of the picture's pixels for which `is`, an expression of red, green and blue, holds.
export function partOf(page, is) {
  return page.evaluate((test) => {
    const picture = document.querySelector('#picture');
    const canvas = Object.assign(document.createElement('canvas'), {width: 160, height: 120});
    const pen = canvas.getContext('2d', {willReadFrequently: true});
    pen.drawImage(picture, 0, 0, 160, 120);
    const {data} = pen.getImageData(0, 0, 160, 120);
    const wanted = new Function('red', 'green', 'blue', `return ${test}`);
    let count = 0;
    for (let at = 0; at < data.length; at += 4) count += wanted(data[at], data[at + 1], data[at + 2]) ? 1 : 0;
    return count / (160 * 120);
  }, is);
}
