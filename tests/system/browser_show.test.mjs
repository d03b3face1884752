// What an evening needs besides playing, tried in a browser with the real programs: line check, lock, lobby, a take by its key,
// and an evening that plays again while one operator is live.
import assert from 'node:assert/strict';
import {after, afterEach, before, test} from 'node:test';

import {middle, openBrowser, openPage, pull, until} from '../hw-sim/browser/harness.mjs';
import {BoxSystem} from './browser_system.mjs';
import {kEyes, View} from './browser_view.mjs';

let box;
let browser;
let page;
let view;

const everyDeviceIsHeard = () => until('every device heard', async () => Object.values((await box.state()).ports).every((p) => p.connected));

before(async () => {
  box = new BoxSystem();
  browser = await openBrowser();
  page = await openPage(browser, await box.address());
  view = new View(page);
  await everyDeviceIsHeard();
  await pull(page, page.getByRole('slider', {name: /^Dial \d: Life$/}), 0, 200);  // Every change is an operator's.
  await page.mouse.up();
});

after(async () => {
  await browser?.close();
  await box?.close();
});

afterEach((test) => {
  if (test.passed === false) console.log(box.logs());
});

const button = (name) => page.getByRole('button', {name: new RegExp(`^Button \\d+: ${name}$`)});
const line = (name) => page.locator('#lines').getByRole('button', {name: new RegExp(`^${name}`)});
const isLit = async (name) => await button(name).getAttribute('aria-pressed') === 'true';
const says = (section, text) => until(`${section} says ${text}`, async () => (await page.locator(`${section} .doing`).textContent()).includes(text));

async function turnService(on) {
  await line('Service').click();
  await until(`the service key ${on}`, async () => await line('Service').getAttribute('aria-pressed') === String(on));
}

async function drag(locator, dx, dy) {
  await pull(page, locator, dx, dy);
  await page.mouse.up();
}

test('a line check is begun with the service key on, ticks what is moved, and moves no face', async () => {
  const call = (name) => page.locator('#check').getByRole('button', {name, exact: true});
  await says('#check', 'Turn the service key on');
  assert.equal(await call('Begin').isDisabled(), true);
  await turnService(true);
  await call('Begin').click();
  await says('#check', 'are seen. Move each control');
  const row = page.locator('#check li li').filter({hasText: /dial 1/i});
  assert.equal(await row.first().getAttribute('data-state'), 'unseen');
  for (const dy of [-170, 340]) await drag(page.getByRole('slider', {name: /^Dial 1/}), 0, dy);
  await until('dial 1 ticked', async () => await row.first().getAttribute('data-state') === 'seen');
  await button('Dog').click();
  await call('End').click();
  await says('#check', 'The last one:');
  assert.equal(await isLit('Dog'), false, 'a button that is checked calls nothing');
  await turnService(false);
});

test('a motion is played by its key, as a take with a key is', async () => {
  const key = page.getByRole('button', {name: 'Look around: key 3'});
  const ahead = await view.atRest();
  await key.click();
  await view.untilMoved('eyes that look around', ahead, kEyes);
  await view.untilBack('eyes that look ahead', ahead, kEyes);
});

test('a show that is locked hears GO and no jump, until the service key is on', async () => {
  const lock = page.locator('#cues').getByRole('button', {name: 'Lock', exact: true});
  const locked = (on) => until(`locked: ${on}`, async () => await lock.getAttribute('aria-pressed') === String(on));
  const active = () => page.locator('#cues li.active').textContent();
  await lock.click();
  await locked(true);
  await says('#cues', 'Locked');
  await line('GO').click({delay: 150});
  await until('GO is heard', async () => (await page.locator('#cues li.active').count()) === 1 && (await active()).startsWith('1House'));
  await page.locator('#cues').getByRole('button', {name: 'Go to cue 24', exact: true}).click();
  await says('#cues', '1 refused');
  assert.match(await active(), /^1House/);
  await turnService(true);
  await locked(false);
  await turnService(false);
});

test('in the lobby the presence switch is a visitor, whom she greets', async () => {
  await page.locator('#cues').getByRole('button', {name: 'Go to cue 40', exact: true}).click();
  await until('cue 40', async () => (await page.locator('#cues li.active').textContent()).startsWith('40'));
  await line('Presence').click();
  await says('#cues', 'Lobby: greeting');
  await says('#cues', 'Lobby: with a visitor');
  await drag(page.locator('#left .pad'), 60, 0);
  await says('#cues', 'Lobby: taken over');
  await line('Presence').click();
  await page.locator('#cues').getByRole('button', {name: 'Go to cue 1', exact: true}).click();
  await until('no lobby', async () => !(await page.locator('#cues .doing').textContent()).includes('Lobby'));
});

test('minus one: an evening plays again by itself, and the page has the operator who is missing', async () => {
  await box.kill('kaori-stage', 'SIGTERM');
  box.log = 'evening';
  box.start('kaori-stage');  // A short evening of its own: Kaori, the dog, and nothing more.
  await until('a stage', async () => (await box.state()).ports.screen.connected);
  await button('Kaori').click();
  await until('Kaori', () => isLit('Kaori'));
  await new Promise((done) => setTimeout(done, 1500));
  await button('Dog').click();
  await until('the dog', () => isLit('Dog'));
  await new Promise((done) => setTimeout(done, 3000));
  await box.kill('kaori-stage', 'SIGTERM');
  box.stage = ['--evening', box.showLog(), '--without', 'head'];
  box.log = 'log';
  box.start('kaori-stage');
  await until('a stage', async () => (await box.state()).ports.screen.connected);
  await until('Kaori again, whom nobody calls', () => isLit('Kaori'));
  const {x, y} = await middle(page.locator('#left .pad'));
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y, {steps: 4});
  const state = async () => (await box.state()).on_stage;
  const yaw = page.locator('#roles li').filter({hasText: 'Head yaw'}).locator('.owner');
  await until('the head in the live hand', async () => (await yaw.textContent()) !== '' && (await state()) !== null);
  await page.mouse.up();
  await until('the dog again, whom nobody calls', () => isLit('Dog'));
});

test('no script of the page failed', () => assert.deepEqual(page.faults.filter((text) => !text.includes('ERR_')), []));
