// The desk in a real browser, by HTTPS: a visitor pairs, samples green paint, calibrates, keeps it and goes back, and sets up the box.
import assert from 'node:assert/strict';
import {join} from 'node:path';
import {after, afterEach, before, test} from 'node:test';

import {openBrowser, until} from '../hw-sim/browser/harness.mjs';
import {DeskHarness, pair, partOf, stateOf, visit} from './browser_desk.mjs';

const kPhone = {viewport: {width: 360, height: 640}, isMobile: true, hasTouch: true};

let harness;
let browser;
let page;

before(async () => {
  harness = new DeskHarness();
  browser = await openBrowser();
  page = await visit(browser, await harness.address());
});

after(async () => {
  await browser?.close();
  await harness?.close();
});

afterEach((test) => {
  if (test.passed === false) console.log(harness.log);
});

const report = async () => (await stateOf(page)).report;
const valueOf = async (name) => (await report()).settings[name].value;
const untilValue = (what, name, is) => until(what, async () => is(await valueOf(name)));
const toast = (message) => until(`the message "${message}"`, async () => (await page.locator('#toast').textContent()) === message);
const choose = (name) => page.getByRole('radio', {name}).click();

test('a visitor without a code sees no picture and changes nothing', async () => {
  assert.equal(await page.locator('#desk').isVisible(), false);
  for (const path of ['state', 'picture', 'picture/mask', 'events'])
    assert.equal(await page.evaluate(async (name) => (await fetch(name)).status, path), 401, path);
  const asked = await page.evaluate(async () => (await fetch('do', {method: 'POST', body: 'defaults'})).status);
  assert.equal(asked, 401);
});

test('a wrong code is refused, and the page says so', async () => {
  const right = await harness.code();
  await page.locator('#code').fill(String((Number(right) + 1) % 1e6).padStart(6, '0'));
  await page.locator('#pair button').click();
  await until('a refusal', async () => (await page.locator('#wrong').textContent()).startsWith('This is not the code'));
  assert.equal(await page.locator('#desk').isVisible(), false);
});

test('the code on the screen authorises the visitor, with a cookie that no script and no other site can read', async () => {
  const used = await harness.code();
  await pair(page, harness);
  const [cookie] = await page.context().cookies();
  assert.equal(cookie.sameSite, 'Strict');
  assert.equal(cookie.httpOnly, true);
  assert.equal(cookie.secure, true);
  assert.notEqual(await harness.code(), used, 'a code authorises one visitor');
});

test('the picture is live, and the paint is not seen yet', async () => {
  await choose('Picture');
  await until('green lips', async () => await partOf(page, 'green > red * 1.5 && green > blue * 1.3') > 0.01);
  assert.ok((await stateOf(page)).mouth.quality < 0.5);
  await choose('Mask');
  await until('a dark mask', async () => await partOf(page, 'red > 100') < 0.001);
});

test('a click on the lips samples the paint, and one on the wall is refused', async () => {
  const {x, y, width, height} = await page.locator('#picture').boundingBox();
  await page.mouse.click(x + width * 0.02, y + height * 0.1);
  await toast('The colour here is grey.');
  await page.mouse.click(x + width * 0.5, y + height * 0.545);
  await toast('The paint was sampled.');
  await until('a mouth', async () => (await stateOf(page)).mouth.quality > 0.8);
  await until('lips in the mask', async () => await partOf(page, 'red > 100') > 0.01);
  assert.ok(await valueOf('paint.green') > await valueOf('paint.red') + 40);
});

test('a slider changes the mask', async () => {
  const lit = await partOf(page, 'red > 100');
  const spill = page.getByRole('slider', {name: 'Spill'});
  await spill.focus();
  await page.keyboard.press('End');
  await untilValue('all that the slider has', 'key.spill', (value) => value === 300);
  await until('a smaller mask', async () => await partOf(page, 'red > 100') < lit / 2);
  await page.getByRole('button', {name: 'Undo'}).click();
  await until('the mask as it was', async () => await partOf(page, 'red > 100') > lit * 0.8);
  const similarity = page.getByRole('slider', {name: 'Similarity'});
  await similarity.focus();
  await page.keyboard.press('ArrowRight');
  await untilValue('one step more', 'key.similarity', (value) => Number.isInteger(value) || value > 0);
});

test('every slider sets its value on the box', async () => {
  const names = {Similarity: 'key.similarity', Smoothness: 'key.smoothness', Spill: 'key.spill',
                 'Stillness, Hz': 'smoothing.least_cutoff_hz', Quickness: 'smoothing.cutoff_per_speed',
                 'Voice from, dB': 'voice.opens_db'};
  for (const [name, value] of Object.entries(names)) {
    const before = await valueOf(value);
    await page.getByRole('slider', {name}).focus();
    await page.keyboard.press('Home');
    await untilValue(name, value, (now) => now < before);
    await page.keyboard.press('ArrowUp');
    await page.getByRole('button', {name: 'Undo'}).click();
  }
});

test('shut, open, wide and narrow are measured', async () => {
  await page.locator('#defaults').evaluate((button) => button.click());
  await page.getByRole('button', {name: 'Find the paint'}).click();
  await toast('The paint was found.');
  const poses = {Shut: [0.25, 1], Open: [0.62, 0.95], Wide: [0.3, 1.14], Narrow: [0.34, 0.8]};
  for (const [name, [height, width]] of Object.entries(poses)) {
    harness.tell(`mouth ${height} ${width}`);
    await new Promise((done) => setTimeout(done, 400));
    await page.getByRole('button', {name: new RegExp(`^${name}`)}).click();
    await until(`${name} done`, async () => (await report()).done.includes(name.toLowerCase()));
  }
  for (const [name, value] of Object.entries({open: 0.59, wide: 1.13, narrow: 0.81})) {
    const learnt = await valueOf(`mouth.${name}`);
    assert.ok(Math.abs(learnt - value) < 0.04, `${name}: ${learnt}`);
  }
  harness.tell('mouth 0.62 0.95');
  await until('a face that opens wholly', async () => (await stateOf(page)).mouth.open > 0.95);
  await until('a drawn mouth that is as open', async () =>
      Number(await page.locator('#live .lips').getAttribute('ry')) > 62 * 0.55);
  harness.tell('mouth 0.25 1');
});

test('saved settings lie on the disk, and the visitor can go back to them and to those before', async () => {
  await page.getByRole('button', {name: 'Save', exact: true}).click();
  await toast('The settings were saved.');
  const first = await valueOf('mouth.open');
  assert.match(harness.settings(), /mouth\.open = 0\.5/);
  await page.getByRole('slider', {name: 'Smoothness'}).focus();
  await page.keyboard.press('End');
  await untilValue('another smoothness', 'key.smoothness', (value) => value === 300);
  await page.locator('#revert summary').click();
  await page.getByRole('button', {name: 'To the saved settings'}).click();
  await untilValue('the saved one', 'key.smoothness', (value) => value === 80);
  await page.getByRole('slider', {name: 'Smoothness'}).focus();
  await page.keyboard.press('Home');
  await untilValue('a third one', 'key.smoothness', (value) => value === 1);
  await page.getByRole('button', {name: 'Save', exact: true}).click();
  await toast('The settings were saved.');
  await page.locator('#revert summary').click();
  await page.getByRole('button', {name: 'To the settings saved before'}).click();
  await untilValue('the one before', 'key.smoothness', (value) => value === 80);
  await page.locator('#revert summary').click();
  await page.getByRole('button', {name: 'To the settings of a new box'}).click();
  await untilValue('a new box', 'mouth.open', (value) => value === 0.85);
  assert.ok(Math.abs(first - 0.59) < 0.04);
});

test('the page says when the lip program ends, and goes on without another code when it is back', async () => {
  harness.tell('lips off');
  await until('that the page says so', async () => (await page.locator('#link').textContent()) === 'The lip program does not answer.');
  harness.tell('lips on');
  await until('live again', async () => (await page.locator('#link').textContent()) === 'Connected');
  assert.equal(await valueOf('key.smoothness'), 1, 'as it was saved');
});

test('the page says when the camera is pulled', async () => {
  harness.tell('camera off');
  await until('that the page says so', async () => (await page.locator('#notice').textContent()) === 'The camera sends no pictures.');
  harness.tell('camera on');
  await until('that the page says nothing', async () => (await page.locator('#notice').textContent()) === '');
});

const kOld = '# ours\nprofile = "stage"\n';
const said = (words) => until(`that the box says "${words}"`, async () => (await page.locator('#machine-said').textContent()).includes(words));
const take = async (name) => {
  const line = page.locator('#machine-list').getByRole('button', {name});
  await until(`the line ${name}`, () => line.isEnabled({timeout: 1000}).catch(() => false));
  await line.click();
};
const compare = async (settings) => {
  await page.locator('#machine-text').fill(settings);
  await page.getByRole('button', {name: 'Check and compare'}).click();
};

test('the list of the box stands on the page while the program for shows runs, with what lies on a stick', async () => {
  await said('The program for shows does not answer.');
  harness.startShows({'data/settings/box.toml': kOld, 'stick/venue.toml': '[stick.left]\ncurve = 0.4\n'});
  await until('the settings of the stick', () => page.locator('#machine-list').getByRole('button', {name: 'settings venue'}).isVisible());
  await said('take a show by its number');
  const name = await page.locator('#name').textContent();
  assert.notEqual(name, '');
  assert.equal(await page.title(), `カ・オ・リ ${name}`);
});

test('settings with a mistake are refused with its line, and the box keeps its own', async () => {
  await page.locator('#machine-settings summary').click();
  assert.equal(await page.locator('#machine-text').inputValue(), kOld);
  await compare('profile = "stage"\n[stick.left]\ndead_zone = 7\n');
  await said('box.toml:3:13: stick.left.dead_zone is not between 0 and 0.9');
  assert.equal(harness.file('data/settings/box.toml'), kOld);
  await page.getByRole('button', {name: 'As they are on the box'}).click();
  assert.equal(await page.locator('#machine-text').inputValue(), kOld);
});

test('settings are shown as what they change, and count once the visitor agrees; those before are kept', async () => {
  const fresh = 'profile = "kiosk"\n\n[network]\naddress = "10.101.90.20/24"\n';
  await compare(fresh);
  await said('nothing has changed yet');
  assert.deepEqual(await page.locator('#machine-notes li').allTextContents(),
                   ['new     network.address  "10.101.90.20/24"', 'changed profile  "stage" -> "kiosk"']);
  await take('leave the settings as they are');
  await said('the box stays as it is');
  assert.equal(harness.file('data/settings/box.toml'), kOld);
  await compare(fresh);
  await take('yes, change them');
  await said('switch the box off and on');
  assert.equal(harness.file('data/settings/box.toml'), fresh);
  assert.equal(harness.file('data/settings/box.before.toml'), kOld);
});

test('a single setting is chosen from the list, in Japanese too', async () => {
  await take('settings of this box');
  await take('profile');
  await page.locator('#language').click();
  await said('値を選んでください');
  assert.equal(await page.locator('#machine-list button').first().textContent(), '設定はそのままにする');
  await until('the value of now', async () => (await page.locator('#machine-list').textContent()).includes('kiosk  今の値'));
  await page.locator('#language').click();
  await take('stage');
  await take('yes, change them');
  await until('the profile in the file', () => harness.file('data/settings/box.toml').startsWith('profile = "stage"\n'));
  await until('the file on the page', async () => (await page.locator('#machine-text').inputValue()).startsWith('profile = "stage"\n'));
});

test('a file of the stick is taken from the page, and the settings before it come back', async () => {
  await take('settings venue');
  await take('yes, change them');
  await until('those of the stick', () => harness.file('data/settings/box.toml').includes('curve = 0.4'));
  await take('settings of this box');
  await take('back to the settings before the last change');
  await take('yes, change them');
  await until('those before', () => harness.file('data/settings/box.toml').startsWith('profile = "stage"\n'));
});

test('a backup is saved from the page, brought back, and restored once the visitor agrees', async () => {
  await page.getByRole('button', {name: 'Make a backup'}).click();
  const fetch = page.locator('#machine-fetch');
  await until('a backup to be saved', () => fetch.isVisible());
  const [download] = await Promise.all([page.waitForEvent('download'), fetch.click()]);
  assert.match(download.suggestedFilename(), /\.kaorishow$/);
  const file = join(harness.folder, download.suggestedFilename());
  await download.saveAs(file);
  harness.write('data/settings/box.toml', 'profile = "bench"\n');
  await page.locator('#machine-file').setInputFiles(file);
  await until('what differs', async () =>
      (await page.locator('#machine-notes').textContent()).includes('changed profile  "bench" -> "stage"'));
  await take('yes, restore this');
  await said('switch the box off and on');
  assert.equal(harness.file('data/settings/box.toml'), 'profile = "bench"\n', 'the next start restores it');
});

test('with the key turned back the list is gone from the page', async () => {
  await harness.turnKeyBack();
  await said('The program for shows does not answer.');
  assert.equal(await page.locator('#machine-list button').count(), 0);
  assert.equal(await page.evaluate(async () => (await fetch('/box', {method: 'POST', body: 'take 0 1'})).status), 503);
});

test('the page is small, and asks no other host for anything', async () => {
  const own = new URL(await harness.address()).origin;
  assert.deepEqual(page.asked.filter((url) => !url.startsWith(own) && !url.startsWith('data:')), []);
  const fresh = await visit(browser, await harness.address());
  await new Promise((done) => setTimeout(done, 300));
  assert.ok(fresh.bytes > 10_000 && fresh.bytes < 200_000, `${fresh.bytes} bytes`);
  await fresh.context().close();
});

test('it reads in Japanese where the browser asks for it, and by a switch', async () => {
  const japanese = await visit(browser, await harness.address(), {...kPhone, locale: 'ja-JP'});
  assert.equal(await japanese.evaluate(() => document.documentElement.lang), 'ja');
  assert.equal(await japanese.locator('h1').textContent(), 'くちびる');
  await japanese.locator('#language').click();
  assert.equal(await japanese.locator('h1').textContent(), 'Lips');
  await japanese.context().close();
});

test('on a telephone everything is large enough for a finger, has a name, and nothing sticks out', async () => {
  for (const locale of ['en-GB', 'ja-JP']) {
    const phone = await visit(browser, await harness.address(), {...kPhone, locale});
    await pair(phone, harness);
    await phone.locator('#revert summary').click();
    const faults = await phone.evaluate(() => {
      const seen = [...document.querySelectorAll('button, summary, input')].filter((element) => element.offsetParent);
      const small = seen.filter((element) => {
        const {width, height} = element.getBoundingClientRect();
        return width < 44 || height < 44;
      });
      const nameless = seen.filter((element) => !(element.textContent.trim() || element.getAttribute('aria-label') ||
                                                  element.labels?.length > 0));
      return {seen: seen.length, out: document.documentElement.scrollWidth - innerWidth,
              small: small.map((element) => element.outerHTML), nameless: nameless.map((element) => element.outerHTML)};
    });
    assert.ok(faults.seen > 18, `${faults.seen} controls`);
    assert.deepEqual([faults.out, faults.small, faults.nameless], [0, [], []], locale);
    await phone.locator('#leave').click();
    await until('that it is left', () => phone.locator('#code').isVisible());
    assert.equal(await phone.evaluate(async () => (await fetch('/state')).status), 401);
    await phone.context().close();
  }
});

test('no script of the page failed', () => {
  assert.deepEqual(page.faults, []);
});
