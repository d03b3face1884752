// The pictures of the docs that show pages, taken in a real browser: KAORI_PICTURES=console,desk. Run by docs/pictures.py.
import {execFileSync} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {test} from 'node:test';

import {middle, openBrowser, openPage, until} from '../tests/hw-sim/browser/harness.mjs';
import * as desk_tests from '../tests/system/browser_desk.mjs';
import {BoxSystem} from '../tests/system/browser_system.mjs';

const kWanted = (process.env.KAORI_PICTURES ?? '').split(',');
const kDocs = join(process.env.KAORI_ROOT, 'docs');
const kSettle_ms = 1500;

const pause = (ms) => new Promise((done) => setTimeout(done, ms));

async function withBrowser(take) {
  const browser = await openBrowser();
  const folder = mkdtempSync(join(tmpdir(), 'kaori-pictures-'));
  try {
    await take(browser, (name) => join(folder, name));
  } finally {
    await browser.close();
    rmSync(folder, {recursive: true, force: true});
  }
}

// A desk and its window, Kaori who smiles to the side: both sticks are held.
test('docs/console.png', {skip: !kWanted.includes('console')}, () => withBrowser(async (browser, file) => {
  const box = new BoxSystem({size: '960x540'});
  try {
    const page = await openPage(browser, await box.address(), {viewport: {width: 1440, height: 900}});
    await until('every device heard', async () => Object.values((await box.state()).ports).every((port) => port.connected));
    await page.evaluate(() => document.querySelector('#hint').classList.add('gone'));
    await page.getByRole('button', {name: /: Smile$/}).click();
    const pad = await middle(page.locator('#left .pad'));
    await page.mouse.move(pad.x, pad.y);
    await page.mouse.down();
    await page.mouse.move(pad.x + 22, pad.y - 12, {steps: 4});
    await pause(kSettle_ms);
    await page.screenshot({path: file('console.png')});
    execFileSync('ffmpeg', ['-loglevel', 'error', '-y', '-i', file('console.png'), '-vf', 'scale=1200:-1:flags=lanczos',
                            join(kDocs, 'console.png')]);
  } finally {
    await box.close();
  }
}));

// The desk on a large screen in English, and on a telephone in Japanese.
test('docs/desk.png', {skip: !kWanted.includes('desk')}, () => withBrowser(async (browser, file) => {
  const harness = new desk_tests.DeskHarness();
  try {
    const page = await desk_tests.visit(browser, await harness.address(), {viewport: {width: 1024, height: 640}, locale: 'en-GB'});
    await desk_tests.pair(page, harness);
    await page.getByRole('button', {name: 'Find the paint'}).click();
    await until('a mouth', async () => (await desk_tests.stateOf(page)).mouth.quality > 0.8);
    harness.tell('mouth 0.25 1');
    await pause(400);
    await page.getByRole('button', {name: /^Shut/}).click();
    await until('shut taken', async () => (await desk_tests.stateOf(page)).report.done.includes('shut'));
    harness.tell('mouth 0.8 0.95');
    await page.getByRole('radio', {name: 'Paint'}).click();
    await pause(kSettle_ms);
    await page.screenshot({path: file('large.png')});
    const phone = await desk_tests.visit(browser, await harness.address(),
                                         {viewport: {width: 296, height: 640}, isMobile: true, hasTouch: true, locale: 'ja-JP'});
    await desk_tests.pair(phone, harness);
    await phone.getByRole('radio').nth(1).click();
    await pause(kSettle_ms);
    await phone.screenshot({path: file('phone.png')});
    execFileSync('ffmpeg', ['-loglevel', 'error', '-y', '-i', file('large.png'), '-i', file('phone.png'),
                            '-filter_complex', 'hstack', join(kDocs, 'desk.png')]);
  } finally {
    await harness.close();
  }
}));
