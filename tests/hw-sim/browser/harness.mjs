// What each browser test plays on: a console-harness process, a browser with its page, and patient questions.
import {spawn} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {createInterface} from 'node:readline';

const {chromium} = createRequire(`${process.env.KAORI_BROWSER_MODULES}/`)('playwright-core');
const kPatience_ms = 20000;

// Asks until the answer is true; the failure says what was hoped for and what was last seen.
export async function until(what, ask) {
  const end = Date.now() + kPatience_ms;
  let seen;
  while (Date.now() < end) {
    seen = await ask();
    if (seen) return seen;
    await new Promise((done) => setTimeout(done, 20));
  }
  throw new Error(`waited ${kPatience_ms} ms for: ${what}; last seen: ${JSON.stringify(seen)}`);
}

// Ends a process that was started here, and waits until it is gone.
export async function end(child, signal) {
  if (child.exitCode !== null || child.signalCode !== null) return;
  const gone = new Promise((done) => child.once('exit', done));
  child.kill(signal);
  await gone;
}

// The simulator and the toy stage, in a process of their own.
export class Harness {
  constructor() {
    this.folder = mkdtempSync(join(tmpdir(), 'kaori-console-'));
    this.process = spawn(join(process.env.KAORI_PROGRAMS, 'console-harness'), [join(this.folder, 'link')],
                         {stdio: ['ignore', 'pipe', 'inherit']});
    this.lines = [];
    createInterface({input: this.process.stdout}).on('line', (line) => this.lines.push(line));
  }

  async address() {
    return until('the address of the page', () => this.lines[0]);
  }

  async state() {
    return (await fetch(new URL('state', await this.address()))).json();
  }

  // The last line of the drivers that begins with `words`, as numbers; nothing if there was none.
  heard(words) {
    const line = this.lines.findLast((text) => text.startsWith(`${words} `));
    return line?.slice(words.length + 1).split(' ').map(Number);
  }

  async close() {
    await end(this.process, 'SIGTERM');
    rmSync(this.folder, {recursive: true, force: true});
  }
}

export async function openBrowser() {
  return chromium.launch({executablePath: process.env.CHROMIUM, args: ['--no-sandbox', '--headless=new']});
}

// Holds the mouse down in the middle of `locator`, moved by so many pixels, until it is let go.
export async function pull(page, locator, dx, dy) {
  const {x, y} = await middle(locator);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx, y + dy, {steps: 8});
}

// The page, shown and listening.
export async function openPage(browser, address, options = {viewport: {width: 1440, height: 900}}) {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  page.faults = [];
  page.asked = [];
  page.on('pageerror', (error) => page.faults.push(error.message));
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && page.faults.push(message.text()));
  page.on('request', (request) => page.asked.push(request.url()));
  await page.goto(address);
  await until('a live picture', () => page.evaluate(() => document.querySelector('#picture').naturalWidth > 0));
  return page;
}

export async function middle(locator) {
  const box = await locator.boundingBox();
  return {x: box.x + box.width / 2, y: box.y + box.height / 2, width: box.width, height: box.height};
}

// Colours of the live picture, as the page shows it, in the rectangle [x, y, width, height].
export async function pixels(page, rectangle) {
  return page.evaluate(([x, y, width, height]) => {
    const picture = document.querySelector('#picture');
    const canvas = Object.assign(document.createElement('canvas'), {width: 960, height: 540});
    const pen = canvas.getContext('2d');
    pen.drawImage(picture, 0, 0);
    return [...pen.getImageData(x, y, width, height).data];
  }, rectangle);
}
