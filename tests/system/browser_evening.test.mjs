// An evening at the page: the line check before the doors open, motions, the lock, and the lobby after the play. What a test does
// next waits for the page's own word that the last thing has happened.
import assert from 'node:assert/strict';
import {after, afterEach, before, test} from 'node:test';

import {openBrowser, openPage, pull, until} from '../hw-sim/browser/harness.mjs';
import {BoxSystem} from './browser_system.mjs';
import {kEyes, View} from './browser_view.mjs';

let box;
let browser;
let page;
let view;

before(async () => {
  box = new BoxSystem({size: '320x180'});
  browser = await openBrowser();
  page = await openPage(browser, await box.address());
  view = new View(page);
  await until('every device heard', async () => Object.values((await box.state()).ports).every((p) => p.connected));
  await pull(page, dial('Life'), 0, 200);
  await page.mouse.up();
  await until('no life', async () => await dial('Life').getAttribute('aria-valuetext') === '0 %');
});

after(async () => {
  await browser?.close();
  await box?.close();
});

afterEach((test) => {
  if (test.passed === false) console.log(box.logs());
});

const dial = (name) => page.getByRole('slider', {name: new RegExp(`^Dial \\d: ${name}$`)});
const button = (name) => page.getByRole('button', {name: new RegExp(`^Button \\d+: ${name}$`)});
const line = (name) => page.locator('#lines').getByRole('button', {name: new RegExp(`^${name}:`)});
const ofTheCheck = (name) => page.locator('#check').getByRole('button', {name, exact: true});
const ofTheList = (name) => page.locator('#cues').getByRole('button', {name, exact: true});
const said = (part) => page.locator(`#${part} .doing`).textContent();
const saying = (part, words) => until(`"${words}" in ${part}`, async () => (await said(part)).includes(words) || null);

// The switch is on when the page shows it so, and not when it was clicked.
async function turn(name, on) {
  await line(name).click();
  await until(`${name} ${on}`, async () => await line(name).getAttribute('aria-pressed') === String(on));
}

// A control of the line check, in the state in which the page shows it.
const item = (words) => page.locator('#check li[data-state]').filter({hasText: words}).first();
async function ticked(control, name) {
  let words;
  const isSeen = async () => {
    words = await control.textContent();
    return await control.getAttribute('data-state') === 'seen';
  };
  await until(`${name} ticked`, isSeen).catch((error) => assert.fail(`${error.message}; the page says: ${words}`));
}

test('a motion nods the head, and lets go of it', async () => {
  const ahead = await view.atRest();
  await page.getByRole('button', {name: 'Nod: key 1'}).click({delay: 100});
  await view.untilMoved('a nod', ahead, kEyes);
  await view.untilBack('a head that looks ahead', ahead, kEyes);
});

test('no line check begins without the service key, and the page says so', async () => {
  assert.equal(await ofTheCheck('Begin').isDisabled(), true);
  await saying('check', 'Turn the service key on');
});

test('a line check ticks what a person moves, moves nothing of the face, and says what it found', async () => {
  await turn('Service', true);
  await until('a check that may begin', async () => await ofTheCheck('Begin').isEnabled());
  await ofTheCheck('Begin').click();
  await saying('check', 'No control moves the face');
  await button('Dog').click();
  await ticked(item('button 9'), 'button 9');
  await dial('Face').scrollIntoViewIfNeeded();
  for (const dy of [-200, 200, 200]) {  // A way up, back, and as far down.
    await pull(page, dial('Face'), 0, dy);
    await page.mouse.up();
  }
  await ticked(item('dial 1'), 'the dial');
  await page.keyboard.press('a', {delay: 150});
  await ticked(page.locator('#check > ol > li').filter({hasText: /^keyboard/}).locator('li'), 'the keyboard');
  await ofTheCheck('End').click();
  await saying('check', 'The last one:');
  assert.match(await said('check'), /The last one: \d+ of \d+ work/);
  await until('the lamps of the show', async () => await button('Kaori').getAttribute('aria-pressed') === 'true');
  assert.equal(await button('Dog').getAttribute('aria-pressed'), 'false');
  await turn('Service', false);
  await until('no check without the key', async () => await ofTheCheck('Begin').isDisabled());
});

test('a locked show hears GO and refuses the rest, and the service key alone takes the lock off', async () => {
  const lock = page.getByRole('button', {name: 'Lock', exact: true});
  const isLocked = (locked) => until(`locked: ${locked}`, async () => await lock.getAttribute('aria-pressed') === String(locked));
  await isLocked(false);
  await lock.click();
  await isLocked(true);
  await saying('cues', 'Locked: only those who play are heard');
  await ofTheList('Pause').click();
  await saying('cues', '1 refused');
  assert.equal((await said('cues')).includes('Paused'), false);
  const active = () => page.locator('#cues li.active').count();
  assert.equal(await active(), 0);
  await ofTheList('GO').click();
  await until('cue 1 was played', async () => await active() === 1);
  await turn('Service', true);
  await isLocked(false);
  await turn('Service', false);
  await ofTheList('Pause').click();
  await saying('cues', 'Paused');
  await ofTheList('Pause').click();
});

test('in the lobby she greets whom the sensor sees, says good-bye, and gives way to an operator', async () => {
  await turn('Presence', true);  // There is a sensor: without one the cue is a cue as any other.
  await ofTheList('Go to cue 40').click();
  await saying('cues', 'Lobby: greeting');
  await saying('cues', 'Lobby: with a visitor');
  await turn('Presence', false);
  await saying('cues', 'Lobby: saying good-bye');
  await saying('cues', 'Lobby: waiting');
  await button('Kaori').click();
  await saying('cues', 'Lobby: taken over');
});

test('no script of the page failed', () => assert.deepEqual(page.faults, []));
