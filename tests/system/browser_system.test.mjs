// The main job, from a control on the page to the picture on the page: report bytes and camera frames on their way
// in, four processes between, and the face that they draw.
import assert from 'node:assert/strict';
import {after, afterEach, before, test} from 'node:test';

import {middle, openBrowser, openPage, pull, until} from '../hw-sim/browser/harness.mjs';
import {BoxSystem} from './browser_system.mjs';
import {kEyes, kMouth, kOther, kWhole, View} from './browser_view.mjs';

let box;
let browser;
let page;
let view;

before(async () => {
  box = new BoxSystem();
  browser = await openBrowser();
  page = await openPage(browser, await box.address());
  view = new View(page);
  await until('every device heard', async () => Object.values((await box.state()).ports).every((p) => p.connected));
  await beStill();
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

const atRest = () => view.atRest();
const untilMoved = (...question) => view.untilMoved(...question);
const untilBack = (...question) => view.untilBack(...question);

// Without the life that the box gives the face, every change is an operator's.
async function beStill() {
  await pull(page, dial('Life'), 0, 200);
  await page.mouse.up();
  await until('no life', async () => await dial('Life').getAttribute('aria-valuetext') === '0 %');
}

test('the page says what the show calls', async () => {
  assert.equal(await button('In love').count(), 1);
  assert.equal(await page.getByRole('button', {name: 'Look around: key 3'}).count(), 1);
  assert.equal(await button('Kaori').getAttribute('aria-pressed'), 'true');
});

test('a dial that the mouse turns opens the mouth, and a double click shuts it', async () => {
  const shut = await atRest();
  await pull(page, dial('Mouth'), 0, -150);
  await page.mouse.up();
  await untilMoved('an open mouth', shut, kMouth);
  await dial('Mouth').dblclick();
  await until('the dial at its start', async () => await dial('Mouth').getAttribute('aria-valuetext') === '0 %');
  await untilBack('a shut mouth', shut, kMouth);
});

test('a button calls another face and its lamp is lit', async () => {
  const kaori = await atRest();
  await button('Dog').click();
  await until('the lamp', async () => await button('Dog').getAttribute('aria-pressed') === 'true');
  assert.equal(await button('Kaori').getAttribute('aria-pressed'), 'false');
  await untilMoved('another face', kaori, kWhole, kOther);
  await button('Kaori').click();
  await untilBack('Kaori', kaori);
});

test('the head stick turns the head while it is held', async () => {
  const ahead = await atRest();
  const pad = page.locator('#left .pad');
  await pull(page, pad, 60, 0);
  await untilMoved('a turned head', ahead, kEyes);
  await page.mouse.up();
  await untilBack('a head that looks ahead', ahead);
});

test('the face is a handle', async () => {
  const ahead = await atRest();
  await pull(page, page.locator('#picture'), -200, 40);
  await until('both sticks to the left', async () => (await box.state()).sticks.every(({x}) => x < -0.3));
  await untilMoved('a turned head', ahead, kEyes);
  await page.mouse.up();
  await untilBack('a head that looks ahead', ahead);
});

test('the space bar shuts the eyes', async () => {
  const open = await atRest();
  await page.keyboard.down('Space');
  await untilMoved('shut eyes', open, kEyes);
  await page.keyboard.up('Space');
  await untilBack('open eyes', open, kEyes);
});

test('the lip pad opens the mouth through the camera', async () => {
  const shut = await atRest();
  await pull(page, page.locator('.lips'), 0, 150);
  await untilMoved('an open mouth', shut, kMouth);
  await page.mouse.up();
  await untilBack('a shut mouth', shut, kMouth);
});

const onStage = (text) => until(text, async () => (await page.locator('#now').textContent()).includes(text));

test('GO calls the next scene, and the page says which scene and which way of drawing are on', async () => {
  await onStage('Scene: Studio');
  await page.locator('#lines').getByRole('button', {name: /^GO/}).click({delay: 150});
  await onStage('Scene: Poster');
  await page.keyboard.press('w', {delay: 150});
  await onStage('Drawn as: Flat');
  await page.keyboard.press('F1', {delay: 150});
  await onStage('Scene: Studio');
});

test('the cue list shows what was played and what stands by, and its calls are played', async () => {
  const standby = () => page.locator('#cues li[aria-current="step"]').textContent();
  const cues = page.locator('#cues li');
  assert.ok(await cues.count() >= 40);
  await until('cue 2 stands by', async () => (await standby()).startsWith('2House lights'));
  assert.match(await page.locator('#standby').textContent(), /^Next: 2 House lights down/);
  const call = (name) => page.locator('#cues').getByRole('button', {name, exact: true}).click();
  await call('GO');
  await until('cue 2 was played', async () => (await page.locator('#cues li.active').textContent()).startsWith('2House'));
  await call('Pause');
  await until('the page says that it pauses', async () => (await page.locator('#cues .doing').textContent()).includes('Paused'));
  await call('Pause');
  await call('Panic');
  await onStage('Scene: Studio');
});

test('a click on a cue lets it stand by, and its button goes there', async () => {
  const active = () => page.locator('#cues li.active').textContent();
  const row = page.locator('#cues li').filter({hasText: 'Flat shaded'});
  await row.getByRole('button', {name: /^11/}).click();
  await until('cue 11 stands by', async () => (await row.getAttribute('aria-current')) === 'step');
  const there = page.locator('#cues li').filter({hasText: 'She barks at the rival'});
  await there.hover();
  await there.getByRole('button', {name: 'Go to cue 24', exact: true}).click();
  await until('the chain of cue 24 was gone to', async () => (await active()).startsWith('24.1'));
  await onStage('Scene: Garden');
  await page.locator('#cues').getByRole('button', {name: 'Go to cue 1', exact: true}).click();
  await until('cue 1 was gone to', async () => (await active()).startsWith('1House'));
  await page.locator('#cues').getByRole('button', {name: 'Panic', exact: true}).click();
  await onStage('Scene: Studio');
});

test('the page says who has a level, moves it from afar, and lets a role be played from another stick', async () => {
  const row = page.locator('#roles li').filter({hasText: 'Head yaw'});
  const owner = (name) => until(`the head is ${name || 'nobody'}'s`, async () => await row.locator('.owner').textContent() === name);
  await owner('');
  await row.getByRole('slider').press('ArrowRight');  // A step to the side; its values are no round numbers.
  await owner('This page');
  await owner('');  // A second after its last word.
  const role = page.getByLabel('Role head is played from');
  await role.selectOption('1');
  await until('the head on the right stick', async () => (await box.state()).on_stage.role_devices[1] === 1);
  await role.selectOption('0');
  await until('the head on the left stick', async () => (await box.state()).on_stage.role_devices[1] === 0);
});

test('blackout makes the picture black, and the tally lamp dark', async () => {
  const lamp = (text) => until(`a ${text} lamp`, async () =>
      await page.locator('.tally').getAttribute('aria-label') === `Tally lamp: ${text}`);
  await lamp('lit');
  const face = await atRest();
  const blackout = page.locator('#lines').getByRole('button', {name: /^Blackout/});
  await blackout.click();
  await untilMoved('a black picture', face, kWhole, kOther);
  await lamp('dark');
  await blackout.click();
  await untilBack('the face', face);
  await lamp('lit');
});

test('a voice in the microphone is heard from the loudspeaker in the browser', async () => {
  const sound = page.locator('#sound');
  await sound.click();
  const {x, y} = await middle(page.getByRole('button', {name: /^Say a/}));
  await page.mouse.move(x, y);
  await page.mouse.down();
  await until('the voice in the page', async () => Number(await sound.getAttribute('data-peak')) > -40);
  await page.mouse.up();
  await until('silence', async () => Number(await sound.getAttribute('data-peak')) < -60);
  await sound.click();
});

test('a stage that dies and comes back goes on with the same face', async () => {
  await button('Kettle').click();
  await until('the lamp', async () => await button('Kettle').getAttribute('aria-pressed') === 'true');
  const kettle = await atRest();
  await box.kill('kaori-stage');
  await until('that nobody draws', async () => !(await box.state()).ports.screen.connected);
  box.start('kaori-stage');
  await until('a stage', async () => (await box.state()).ports.screen.connected);
  await untilBack('the same face', kettle);
  await button('Kaori').click();
  await untilMoved('another face', kettle, kWhole, kOther);
});

test('the page goes on when the simulator has died and come back', async () => {
  const link = () => page.evaluate(() => document.body.dataset.link);
  const kaori = await atRest();
  await box.kill('kaori-sim');
  await until('a page that says so', async () => await link() === 'lost');
  box.start('kaori-sim');
  await until('a page that listens', async () => await link() === 'live');
  await until('every device heard', async () => Object.values((await box.state()).ports).every((p) => p.connected));
  await button('Dog').click();
  await untilMoved('another face', kaori, kWhole, kOther);
});

test('no script of the page failed', () => {
  const faults = page.faults.filter((text) => !text.includes('ERR_'));  // A browser's word for a simulator that is gone.
  assert.deepEqual(faults, []);
});
