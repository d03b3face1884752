// The console's page in a real browser: input on the page becomes report bytes, and what the show draws comes back.
import assert from 'node:assert/strict';
import {request} from 'node:http';
import {after, before, test} from 'node:test';

import {Harness, middle, openBrowser, openPage, pixels, pull, until} from './harness.mjs';

const kUpright = [60, 225, 4, 30];    // Where the toy stage draws the hand of dial 1 at rest,
const kQuarter = [65, 268, 30, 4];    // and after a quarter of a turn clockwise.

let harness;
let browser;
let page;

before(async () => {
  harness = new Harness();
  browser = await openBrowser();
  page = await openPage(browser, await harness.address());
});

after(async () => {
  await browser?.close();
  await harness?.close();
});

const knob = (number) => page.locator('.knob').nth(number - 1);

// The toy stage's clock hands are yellow; its backdrop never is.
async function isYellow(rectangle) {
  const rgba = await pixels(page, rectangle);
  let yellow = 0;
  for (let at = 0; at < rgba.length; at += 4) yellow += rgba[at] > 170 && rgba[at + 1] > 170 && rgba[at + 2] < 150;
  return yellow > rgba.length / 4 / 3;
}

async function drag(locator, dx, dy) {
  await pull(page, locator, dx, dy);
  await page.mouse.up();
}

test('a dial that the mouse turns turns on the box, in the drivers and in the picture', async () => {
  await until('the hand of dial 1 upright', () => isYellow(kUpright));
  await drag(knob(1), 0, -45);  // A quarter of 180 pixels.
  await until('a quarter of 256 counts', () => harness.heard('dial 1')?.[0] === 64);
  assert.equal((await harness.state()).dials[0], 0.25);
  await until('the hand to the right', () => isYellow(kQuarter));
  assert.equal(await isYellow(kUpright), false);
  assert.equal(await knob(1).getAttribute('aria-valuetext'), '0.25 turns');
});

test('a dial goes round with its rim', async () => {
  const {x, y, width} = await middle(knob(2));
  const radius = width * 0.46;
  const at = (turns) => [x + Math.sin(turns * 2 * Math.PI) * radius, y - Math.cos(turns * 2 * Math.PI) * radius];
  await page.mouse.move(...at(0));
  await page.mouse.down();
  for (let step = 1; step <= 24; ++step) await page.mouse.move(...at(step / 16));
  await page.mouse.up();
  await until('one and a half turns clockwise', () => Math.abs(harness.heard('dial 2')?.[0] - 384) <= 4);
});

test('a dial turns by wheel and by arrow keys', async () => {
  const {x, y} = await middle(knob(3));
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -300);
  await until('an eighth of a turn by wheel', () => harness.heard('dial 3')?.[0] === 32);
  await knob(4).focus();
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ArrowDown');
  await until('one step by keys', () => harness.heard('dial 4')?.[0] === 8);
  assert.equal(harness.heard('key 82'), undefined, 'the arrows are the dial\'s while it has the focus');
  await knob(4).blur();
});

test('a button lights the lamp that the show says', async () => {
  const button = page.getByRole('button', {name: 'Button 1: Kaori'});
  assert.equal(await button.getAttribute('aria-pressed'), 'false');
  await button.click();
  await until('button 1 down and up', () => harness.lines.includes('button 1 1') && harness.lines.includes('button 1 0'));
  await until('its lamp', async () => await button.getAttribute('aria-pressed') === 'true');
  await button.click();
  await until('its lamp out', async () => await button.getAttribute('aria-pressed') === 'false');
});

test('the space bar blinks, also after a click, and the picture shows it', async () => {
  await page.getByRole('button', {name: 'Button 2: Dog'}).click();
  await page.keyboard.down('Space');
  await until('key 44 down', () => harness.heard('key 44')?.[0] === 1);
  await until('a dark picture', async () => Math.max(...(await pixels(page, [10, 10, 4, 4])).filter((_, n) => n % 4 < 3)) < 20);
  await page.keyboard.up('Space');
  await until('key 44 up', () => harness.heard('key 44')?.[0] === 0);
  assert.equal(harness.lines.filter((line) => line === 'button 2 1').length, 1, 'Space did not push the button');
});

test('keys that are held when the page loses the keyboard are let go', async () => {
  await page.keyboard.down('KeyQ');
  await until('key 20 down', () => harness.heard('key 20')?.[0] === 1);
  await page.evaluate(() => window.dispatchEvent(new Event('blur')));
  await until('key 20 up', () => harness.heard('key 20')?.[0] === 0);
  await page.keyboard.up('KeyQ');
});

test('a cap on the page presses its key while it is held', async () => {
  const {x, y} = await middle(page.getByRole('button', {name: 'Nod: key 1'}));
  await page.mouse.move(x, y);
  await page.mouse.down();
  await until('key 30 down', () => harness.heard('key 30')?.[0] === 1);
  await page.mouse.up();
  await until('key 30 up', () => harness.heard('key 30')?.[0] === 0);
});

test('the lip pad opens the lips before the camera, and they spring shut', async () => {
  const pad = page.locator('.lips');
  const {x, y, height} = await middle(pad);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y + height * 0.45, {steps: 4});
  await until('an open mouth', async () => (await harness.state()).lips.height > 1);
  await page.mouse.up();
  await until('a shut mouth', async () => (await harness.state()).lips.height === 0.25);
});

test('a twist and the lips are moved by the arrow keys, and spring back', async () => {
  const twist = page.getByRole('slider', {name: /the twist$/}).first();
  await twist.focus();
  await page.keyboard.down('ArrowRight');
  await until('a twist to the right', () => harness.heard('stick-left')?.[2] > 0.7);
  assert.equal(await twist.getAttribute('aria-valuenow'), '80');
  await page.keyboard.up('ArrowRight');
  await until('a twist at rest', () => harness.heard('stick-left')[2] === 0);
  const lips = page.locator('.lips');
  await lips.focus();
  await page.keyboard.down('ArrowDown');
  await page.keyboard.down('ArrowRight');
  await until('an open, wide mouth', async () => {
    const {height, width} = (await harness.state()).lips;
    return height > 0.9 && width > 1.3;
  });
  await page.keyboard.up('ArrowDown');
  await page.keyboard.up('ArrowRight');
  await until('a shut mouth', async () => (await harness.state()).lips.height === 0.25);
  assert.equal(harness.heard('key 79'), undefined, 'the arrows are those of the control that has the focus');
  await lips.blur();
});

test('every control can be reached by keys and has a name', async () => {
  const nameless = await page.evaluate(() => [...document.querySelectorAll('button, input, [role="slider"], [role="application"]')]
      .filter((element) => element.offsetParent)
      .filter((element) => element.tabIndex < 0 || !(element.getAttribute('aria-label') || element.textContent.trim()))
      .map((element) => element.outerHTML.slice(0, 80)));
  assert.deepEqual(nameless, []);
  const vowels = await page.locator('.voice button').evaluateAll((all) => all.map((button) => button.title));
  assert.deepEqual(vowels.map((title) => title.startsWith('Hold it to say')), Array(5).fill(true));
});

test('ways of drawing stand in the order of their keys', async () => {
  const keys = await page.locator('#keys .cap[data-group="style"] kbd').allTextContents();
  assert.deepEqual(keys, ['Q', 'W', 'R']);
});

test('the page says which scene and which way of drawing are on', async () => {
  await until('both names', async () => await page.locator('#now').textContent() === 'Scene: Poster \u00b7 Drawn as: Wireframe');
});

test('switches reach the drivers as lines, and the tally lamp is what the box says', async () => {
  const tally = page.locator('.tally');
  await until('a lit lamp', async () => await tally.getAttribute('aria-label') === 'Tally lamp: lit');
  const go = page.getByRole('button', {name: /^GO/});
  const {x, y} = await middle(go);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await until('GO down', () => harness.heard('line 0')?.[0] === 1);
  await page.mouse.up();
  await until('GO up', () => harness.heard('line 0')[0] === 0);
  for (const [name, line] of [['Back', 4], ['Panic', 5]]) {
    const held = await middle(page.locator('#lines').getByRole('button', {name: new RegExp(`^${name}`)}));
    await page.mouse.move(held.x, held.y);
    await page.mouse.down();
    await until(`${name} down`, () => harness.heard(`line ${line}`)?.[0] === 1);
    await page.mouse.up();
    await until(`${name} up`, () => harness.heard(`line ${line}`)[0] === 0);
  }
  const blackout = page.getByRole('button', {name: /^Blackout/});
  await blackout.click();
  await until('a latched switch', async () => harness.heard('line 1')?.[0] === 1 && await blackout.getAttribute('aria-pressed') === 'true');
  await until('a dark lamp', async () => await tally.getAttribute('aria-label') === 'Tally lamp: dark');
  await blackout.click();
  await until('blackout off', () => harness.heard('line 1')[0] === 0);
  for (const [name, line] of [['Service', 2], ['Presence', 3]]) {
    const button = page.getByRole('button', {name: new RegExp(`^${name}`)});
    await button.click();
    await until(`${name} on`, async () => harness.heard(`line ${line}`)?.[0] === 1 && await button.getAttribute('aria-pressed') === 'true');
    await button.click();
    await until(`${name} off`, () => harness.heard(`line ${line}`)[0] === 0);
  }
});

test('the sound of the loudspeaker is played when it is asked for, and not before', async () => {
  const sound = page.locator('#sound');
  assert.equal(page.asked.some((url) => url.endsWith('/sound')), false, 'nobody asked for it');
  await sound.click();
  await until('a second of sound', async () => Number(await sound.getAttribute('data-frames')) > 48000);
  // The toy stage plays 8000 of 32768: -12 dB. The analyser hears what leaves the page.
  await until('the tone in the page', async () => Math.abs(Number(await sound.getAttribute('data-peak')) + 12.2) < 1);
  await sound.click();
  await until('a page that plays nothing', async () => await sound.getAttribute('data-frames') === '0');
  await new Promise((done) => setTimeout(done, 300));
  assert.equal(await sound.getAttribute('data-frames'), '0', 'it stays off');
});

test('a cable that is pulled takes the device away, and back', async () => {
  await page.getByRole('button', {name: 'Unplug the dial box'}).click();
  await until('an unplugged box', async () => (await harness.state()).ports['dial-box'].plugged === false);
  await page.getByRole('button', {name: 'Plug in the dial box'}).click();
  await until('a box that is there', async () => (await harness.state()).ports['dial-box'].connected);
  // The page takes no pointer for a device of which it has not heard yet that it is back.
  await page.getByRole('button', {name: 'Unplug the dial box'}).waitFor();
  // What is turned before the drivers' first look at it is where it stands, and no turn.
  const stood = harness.heard('dial 4')?.[0];
  await until('a box that is heard', async () => {
    await knob(4).press('ArrowUp');
    return harness.heard('dial 4')?.[0] !== stood;
  });
  await knob(4).blur();
  const before = harness.heard('dial 1')[0];
  await drag(knob(1), 0, 45);
  await until('a quarter back', () => harness.heard('dial 1')[0] === before - 64);
});

test('two fingers move two sticks at once, and both spring back', async () => {
  const phone = {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true};
  const touched = await openPage(browser, await harness.address(), phone);
  await touched.locator('#left').scrollIntoViewIfNeeded();
  const left = await middle(touched.locator('#left .pad'));
  const right = await middle(touched.locator('#right .pad'));
  const fingers = await touched.context().newCDPSession(touched);
  const touch = (type, points) => fingers.send('Input.dispatchTouchEvent', {type, touchPoints: points});
  const at = (pad, id, dx, dy) => ({id, x: pad.x + dx * pad.width / 2, y: pad.y + dy * pad.width / 2});
  await touch('touchStart', [at(left, 0, 0, 0), at(right, 1, 0, 0)]);
  await touch('touchMove', [at(left, 0, 0.8, 0), at(right, 1, 0, 0.8)]);
  await until('left stick to the right', () => harness.heard('stick-left')?.[0] > 0.7);
  await until('right stick pulled back', () => harness.heard('stick-right')?.[1] < -0.7);
  await touch('touchEnd', []);
  await until('both in the middle', () => harness.heard('stick-left')[0] === 0 && harness.heard('stick-right')[1] === 0);
  await touched.context().close();
});

test('a slider stays where it is put', async () => {
  await page.getByRole('slider', {name: /^Head: .*, the slider$/}).fill('0.5');
  await until('half way', () => harness.heard('stick-left')?.[3] === 0.5);
});

test('a button of a stick is down for as long as it is held', async () => {
  const button = page.getByRole('button', {name: 'Head, button 3', exact: true});
  const {x, y, width, height} = await button.boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await until('button 3 down', async () => (await harness.state()).sticks[0].buttons === 1 << 2);
  await until('a button that is seen to be down', async () => await button.getAttribute('aria-pressed') === 'true');
  await page.mouse.up();
  await until('button 3 up', async () => (await harness.state()).sticks[0].buttons === 0);
  await page.getByRole('button', {name: 'Gaze and brows, button 12: Laugh'}).focus();
  await page.keyboard.press('Enter');
  await until('button 12 up again', async () => (await harness.state()).sticks[1].buttons === 0);
});

const needles = () => page.getByRole('button', {name: 'Needles', exact: true});

async function openNeedles() {
  await needles().click();
  await until('Tab down and up', () => harness.lines.includes('key 43 1') && harness.heard('key 43')?.[0] === 0);
  await until('open needles', async () => (await harness.state()).editor_open);
  await until('a switch that is lit', async () => await needles().getAttribute('aria-pressed') === 'true');
}

test('with the needles open the mouse over the picture is the pointer, and not a drag of the face', async () => {
  await openNeedles();
  const sticks = harness.lines.filter((line) => line.startsWith('stick-')).length;
  const {x, y, width, height} = await middle(page.locator('#picture'));
  await page.mouse.move(x - width / 4, y - height / 4);
  await until('the pointer at a quarter', () => harness.heard('pointer')?.every((v, n) => Math.abs(v - [0.25, 0.25, 0, 0][n]) < 0.01));
  await page.mouse.down();
  await page.mouse.move(x, y, {steps: 5});
  await page.mouse.up();
  await until('the middle', () => harness.heard('pointer')?.every((v, n) => Math.abs(v - [0.5, 0.5, 0, 0][n]) < 0.01));
  const pushed = harness.lines.filter((line) => /^pointer \S+ \S+ 1/.test(line));
  assert.match(pushed[0], /^pointer 0.25\d 0.25/, 'it went down where the mouse was');
  await page.mouse.wheel(0, -200);
  await until('two notches', () => harness.heard('pointer')?.[3] === 2);
  await page.mouse.down({button: 'right'});
  await until('the second button', () => harness.heard('pointer')?.[2] === 2);
  await page.mouse.up({button: 'right'});
  await until('no button', () => harness.heard('pointer')?.[2] === 0);
  assert.equal(harness.lines.filter((line) => line.startsWith('stick-')).length, sticks, 'the sticks stood still');
});

test('the tools of the needles press the keys of the show while they are held', async () => {
  const down = (usage) => harness.lines.filter((line) => line === `key ${usage} 1`).length;
  for (const [name, usage] of [['Mirror', 16], ['Smooth', 22], ['Undo', 29], ['Redo', 28], ['Zero', 42], ['Name', 17], ['Save', 40], ['Delete', 76]]) {
    const before = down(usage);
    await page.getByRole('button', {name: new RegExp(`^${name}\\b`)}).click();
    await until(`${name}: key ${usage}`, () => down(usage) === before + 1 && harness.heard(`key ${usage}`)[0] === 0);
  }
  const {x, y} = await middle(page.getByRole('button', {name: /^Compare/}));
  await page.mouse.move(x, y);
  await page.mouse.down();
  await until('C held', () => harness.heard('key 6')?.[0] === 1);
  await page.mouse.up();
  await until('C let go', () => harness.heard('key 6')?.[0] === 0);
});

test('a chord lasts long enough for a show that looks once a frame', async () => {
  await page.getByRole('button', {name: /^As new/}).click();
  await until('shift let go', () => harness.heard('key 225')?.[0] === 0);
  const keys = harness.lines.filter((line) => /^key (225|40) /.test(line)).slice(-4);
  assert.deepEqual(keys, ['key 225 1', 'key 40 1', 'key 40 0', 'key 225 0']);
});

test('a finger points, too, and writes a name without a keyboard', async () => {
  const phone = {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true};
  const touched = await openPage(browser, await harness.address(), phone);
  await until('tools', () => touched.getByRole('button', {name: /^Mirror/}).isVisible());
  const picture = await middle(touched.locator('#picture'));
  await touched.touchscreen.tap(picture.x + picture.width / 4, picture.y);
  await until('a tap at three quarters', () => harness.lines.some((line) => /^pointer 0.75\d 0.50\d 1/.test(line)));
  await touched.getByRole('textbox', {name: 'Type on the keyboard'}).pressSequentially('aB_');
  const typed = () => harness.lines.filter((line) => /^key \d+ 1$/.test(line)).slice(-4).join();
  await until('a, shift and B, minus', () => typed() === 'key 4 1,key 5 1,key 225 1,key 45 1' || typed() === 'key 4 1,key 225 1,key 5 1,key 45 1');
  await touched.getByRole('button', {name: 'The needle outwards'}).tap();
  await until('a notch', () => harness.heard('pointer')?.[3] === 3);
  await touched.context().close();
});

test('the needles are shut by the same switch, and the face is a handle again', async () => {
  await needles().click();
  await until('shut needles', async () => !(await harness.state()).editor_open);
  await until('a switch that is not lit', async () => await needles().getAttribute('aria-pressed') === 'false');
  const {x, y, width} = await middle(page.locator('#picture'));
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + width / 4, y, {steps: 4});
  await until('sticks to the right', () => harness.heard('stick-left')?.[0] > 0.3 && harness.heard('stick-right')?.[0] > 0.2);
  await page.mouse.up();
  await until('sticks at rest', () => harness.heard('stick-left')[0] === 0);
});

test('a switch that is pushed and let go in one message opens the needles, and the next one shuts them', async () => {
  for (const open of [true, false]) {
    await page.evaluate(() => fetch('/input', {method: 'POST', body: 'key usage-43 press\nkey usage-43 release'}));
    await until(`needles that are ${open ? 'open' : 'shut'}`, async () => (await harness.state()).editor_open === open);
  }
});

test('a page that is closed in the middle of a drag lets go', async () => {
  await page.goto('about:blank');  // The only page that listens shall be the one that is closed.
  const leaving = await openPage(browser, await harness.address());
  const {x, y, width} = await middle(leaving.locator('#left .pad'));
  await leaving.mouse.move(x, y);
  await leaving.mouse.down();
  await leaving.mouse.move(x + width * 0.4, y, {steps: 4});
  await until('a stick to the right', () => harness.heard('stick-left')[0] > 0.7);
  await leaving.context().close();
  await until('the stick in the middle', () => harness.heard('stick-left')[0] === 0);
  await page.goto(await harness.address());
});

test('several pages see the same box', async () => {
  const second = await openPage(browser, await harness.address());
  await drag(knob(5), 0, -90);
  await until('the dial on the other page', async () =>
      await second.locator('.knob').nth(4).getAttribute('aria-valuetext') === '0.50 turns');
  await second.context().close();
});

test('the page fits a phone and a desk without a sideways scroll', async () => {
  for (const [width, height] of [[360, 740], [390, 844], [820, 1180], [1280, 720], [1440, 900], [2560, 1440]]) {
    await page.setViewportSize({width, height});
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= width, `${wide} px are needed at ${width}x${height}`);
    const {width: pad} = await page.locator('#left .pad').boundingBox();
    assert.ok(pad >= 80, `a stick's pad of ${pad} px is for no finger at ${width}x${height}`);
  }
  await page.setViewportSize({width: 1440, height: 900});
});

test('the picture comes at 15 frames/s at least, at 960x540', async () => {
  const kSeconds = 3;
  const stop = new AbortController();
  const stream = await fetch(new URL('picture', await harness.address()), {signal: stop.signal});
  let frames = 0;
  const start = performance.now();
  for await (const part of stream.body) {
    frames += Buffer.from(part).toString('latin1').split('Content-Type: image/jpeg').length - 1;
    if (performance.now() - start > kSeconds * 1000) break;
  }
  stop.abort();
  console.log(`${(frames / kSeconds).toFixed(1)} frames/s beside the page's own`);
  assert.ok(frames >= 15 * kSeconds, `${frames} frames in ${kSeconds} s`);
});

// A request with headers that a browser would not let a page set.
async function status(headers, method = 'POST', body = 'dial 8 turn 1') {
  const url = new URL('input', await harness.address());
  return new Promise((done, fail) => {
    request(url, {method, headers}, (reply) => reply.resume().on('end', () => done(reply.statusCode)))
        .on('error', fail).end(body);
  });
}

test('only the page itself may play', async () => {
  const {origin, host} = new URL(await harness.address());
  assert.equal(await status({Host: 'kaori.example'}), 403);
  assert.equal(await status({Host: host, Origin: 'http://kaori.example'}), 403);
  assert.equal(await status({Host: host, 'Sec-Fetch-Site': 'cross-site'}), 403);
  assert.equal((await harness.state()).dials[7], 0);
  assert.equal(await status({Host: host, Origin: origin}), 204);
  assert.equal((await harness.state()).dials[7], 1);
});

test('bad input is refused in one clear line, and a long one unread', async () => {
  const reply = await fetch(new URL('input', await harness.address()), {method: 'POST', body: 'dial 9 turn 1'});
  assert.equal(reply.status, 400);
  assert.equal(await reply.text(), '1:6: no dial 9; dials are 1 to 8\n');
  const {host} = new URL(await harness.address());
  assert.equal(await status({Host: host}, 'POST', 'dial 1 turn 0\n'.repeat(1000)), 413);
  assert.equal(await status({Host: host}, 'DELETE', ''), 405);
});

test('nothing was asked of another machine, and no script failed', async () => {
  const {origin} = new URL(await harness.address());
  assert.deepEqual(page.asked.filter((url) => !url.startsWith(origin)), []);
  assert.deepEqual(page.faults, []);
});

test('the page waits for a simulator that has stopped', async () => {
  harness.process.kill('SIGTERM');
  await until('the word that it stopped', () => page.evaluate(() => document.body.dataset.link === 'lost'));
});
