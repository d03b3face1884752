// The texts of the page in English and Japanese, and those of the lips' complaints.

const kTexts = {
  en: {
    title: 'Lips',
    other: '日本語',
    otherLabel: 'Read this page in Japanese',
    pairTitle: 'Pair with the box',
    pairText: 'Type the six digits that the box shows on its own screen.',
    code: 'The six digits',
    pair: 'Pair',
    wrongCode: 'This is not the code on the screen.',
    wait: 'Five codes were wrong. Wait a minute, then look at the screen again.',
    live: 'Connected',
    lost: 'The desk does not answer.',
    noLips: 'The lip program does not answer.',
    noCamera: 'No camera is plugged in.',
    stale: 'The camera sends no pictures.',
    waiting: 'Connecting …',
    pictureLabel: 'What the lip camera sees. Tap the paint to sample it.',
    views: 'How the picture is shown',
    viewPlain: 'Picture',
    viewBoth: 'Paint',
    viewMask: 'Mask',
    tap: 'Tap the paint on the lips.',
    find: 'Find the paint',
    paintLabel: 'The paint',
    sampled: 'The paint was sampled.',
    found: 'The paint was found.',
    mouth: 'Mouth',
    mouthLabel: 'The mouth as it is measured',
    opened: 'open',
    wide: 'wide',
    height: 'height',
    width: 'width',
    quality: 'quality',
    age: 'age',
    steps: 'Calibrate the mouth',
    stepsText: 'Hold each pose for a second, or speak for ten seconds.',
    shut: 'Shut',
    open: 'Open',
    wideStep: 'Wide',
    narrow: 'Narrow',
    speak: 'Speak for ten seconds',
    hold: 'Hold the pose …',
    speaking: 'Speak …',
    noMouth: 'No mouth is seen.',
    doneStep: 'Done',
    stop: 'Stop',
    tuning: 'Fine tuning',
    similarity: 'Similarity',
    similarityText: 'A higher value counts more colours as paint.',
    smoothness: 'Smoothness',
    smoothnessText: 'How soft the edge of the paint is.',
    spill: 'Spill',
    spillText: 'A higher value ignores more of the paint\'s reflection on skin and teeth.',
    still: 'Stillness, Hz',
    stillText: 'Cut-off frequency of a mouth at rest: a lower value is stiller.',
    quick: 'Quickness',
    quickText: 'Cut-off frequency gained with speed: a higher value follows sooner.',
    gate: 'Voice from, dB',
    gateText: 'Louder sound counts as a voice.',
    delay: 'Sound delay, ms',
    delayText: '-1 delays the sound as long as the picture.',
    presented: 'to the screen',
    freeExposure: 'Adjust exposure',
    holdExposure: 'Hold exposure',
    freed: 'The camera adjusts its exposure.',
    held: 'The exposure of the camera is held.',
    undo: 'Undo',
    revert: 'Go back …',
    saved: 'To the saved settings',
    before: 'To the settings saved before',
    defaults: 'To the settings of a new box',
    leave: 'Leave the desk',
    save: 'Save',
    savedNow: 'The settings were saved.',
    reverted: 'The change was undone.',
    gone: 'The lip program does not answer.',
    machine: 'The box',
    machineGone: 'The program for shows does not answer.',
    machineMore: 'and N more on the stick; take some off it to see them',
    machineBackup: 'Make a backup',
    machineFetch: 'Save NAME',
    machineBring: 'Restore a backup …',
    machineSettings: 'All settings (box.toml)',
    machineText: 'What is written here takes the place of all settings. It is checked and compared first; nothing changes before you say yes above.',
    machineCompare: 'Check and compare',
    machineAgain: 'As they are on the box',
  },
  ja: {
    title: 'くちびる',
    other: 'English',
    otherLabel: 'このページを英語で読む',
    pairTitle: 'ボックスとつなぐ',
    pairText: 'ボックスの画面に出ている六けたの数字を入れてください。',
    code: '六けたの数字',
    pair: 'つなぐ',
    wrongCode: '画面の数字と違います。',
    wait: '五回まちがえました。一分待って、画面をもう一度見てください。',
    live: '接続中',
    lost: 'デスクが応答しません',
    noLips: 'くちびるのプログラムが応答しません',
    noCamera: 'カメラがありません',
    stale: 'カメラから映像が来ません',
    waiting: 'お待ちください',
    pictureLabel: 'カメラの映像。塗料に触れると色を取ります。',
    views: '映像の見せ方',
    viewPlain: '映像',
    viewBoth: '塗料',
    viewMask: 'マスク',
    tap: 'くちびるの塗料に触れてください。',
    find: '自動で探す',
    paintLabel: '塗料の色',
    sampled: '色を取りました',
    found: '塗料を見つけました',
    mouth: '口',
    mouthLabel: '測っている口の形',
    opened: '開き',
    wide: '横',
    height: '高さ',
    width: '幅',
    quality: '確かさ',
    age: '遅れ',
    steps: '口を覚える',
    stepsText: 'それぞれ一秒そのままで。話すだけでもかまいません。',
    shut: 'とじる',
    open: 'あける',
    wideStep: 'ひろげる',
    narrow: 'すぼめる',
    speak: '十秒間話す',
    hold: 'そのまま…',
    speaking: '話して…',
    noMouth: '口が見えません',
    doneStep: '済み',
    stop: 'やめる',
    tuning: '微調整',
    similarity: '類似度',
    similarityText: '大きいほど多くの色を塗料とみなします。',
    smoothness: 'なめらかさ',
    smoothnessText: '塗料のふちのやわらかさ。',
    spill: '照り返し',
    spillText: '大きいほど肌や歯への照り返しを除きます。',
    still: '静けさ Hz',
    stillText: '静止した口の遮断周波数。小さいほど揺れません。',
    quick: '素早さ',
    quickText: '速さで増す遮断周波数。大きいほど早くついていきます。',
    gate: '声とみなす音量 dB',
    gateText: 'これより大きい音を声とみなします。',
    delay: '音の遅れ ms',
    delayText: '-1 は映像の遅れに合わせます。',
    presented: '画面まで',
    freeExposure: '明るさを合わせる',
    holdExposure: '明るさを固定',
    freed: 'カメラが明るさを合わせています',
    held: 'カメラを固定しました',
    undo: '一つ戻す',
    revert: '戻す…',
    saved: '保存したもの',
    before: 'その前に保存したもの',
    defaults: '工場出荷時',
    leave: 'デスクを離れる',
    save: '保存',
    savedNow: '保存しました',
    reverted: '戻しました',
    gone: 'くちびるのプログラムがありません',
    machine: '箱',
    machineGone: 'ショーのプログラムがありません',
    machineMore: 'スティックにあと N 個あります。見るには何か消してください',
    machineBackup: 'バックアップを作る',
    machineFetch: 'NAME を保存',
    machineBring: 'バックアップを復元…',
    machineSettings: 'すべての設定 (box.toml)',
    machineText: 'ここに書いたものが設定全体になります。まず調べて比べます。上で「はい」と答えるまで何も変わりません。',
    machineCompare: '調べて比べる',
    machineAgain: '箱の今の設定に戻す',
  },
};

// The complaints of the lips, as protocol and calibration word them.
const kComplaints = {
  'sample the paint: the colour here is grey': 'ここは灰色です',
  'sample the paint: there are several colours here': 'ここには色がいくつもあります',
  'sample the paint: the click is outside the picture': '映像の外です',
  'no paint was found in the picture': '塗料が見つかりません',
  'no picture comes from the camera': 'カメラから映像が来ません',
  'there is no change to undo': '戻すものがありません',
  'no settings are saved': '保存したものがありません',
  'the settings are being saved already': '保存しています',
  'there is no file to save the settings in': '保存する場所がありません',
  'mouth.shut is not below mouth.open': 'とじた口があけた口より大きくなっています',
};

// Lines of the box's list, as kaori-shows words them; names of files and of screens stay as they are.
const kLines = {
  'back to the show before': '前のショーに戻す',
  'back to the box\'s own show': '箱のショーに戻す',
  'back to what was here before the restore': '復元の前に戻す',
  'back to the settings before the last change': '変更前の設定に戻す',
  'backup of this box, onto the stick': 'この箱のバックアップをスティックに書く',
  'support file for a technician, onto the stick': '技術者のためのサポートファイルをスティックに書く',
  'settings of this box': 'この箱の設定',
  'leave the settings as they are': '設定はそのままにする',
  'leave the box as it is': '箱はそのままにする',
  'leave this key out': 'この鍵は入れない',
  'yes, trust this key': 'はい、この鍵を入れる',
  'yes, change them': 'はい、変更する',
  'yes, restore this': 'はい、復元する',
  'profile': '使い方 (profile)',
  'screen that shows the status': '状態を表示する画面',
  'operators\' monitor': '操作者のモニター',
  'none': 'なし',
  'as it is': '今の値',
};
const kKinds = {'key ': '鍵 ', 'update ': '更新 ', 'restore ': '復元 ', 'settings ': '設定 '};

const kLanguageKey = 'kaori-desk-language';
const listeners = [];
let chosen = localStorage.getItem(kLanguageKey) ?? document.documentElement.lang;
if (!(chosen in kTexts)) chosen = 'en';

// 'en' or 'ja'.
export function language() {
  return chosen;
}

export function text(key) {
  return kTexts[chosen][key];
}

export function complaint(message) {
  if (chosen === 'ja' && message in kComplaints) return kComplaints[message];
  const short = message.replace('sample the paint: ', '');
  return `${short.charAt(0).toUpperCase()}${short.slice(1)}.`;
}

// A line of the list: what it is, and two spaces before what is said of it.
export function listLine(label) {
  if (chosen === 'en') return label;
  const parts = label.split('  ').map((part) => kLines[part] ?? part);
  const kind = Object.keys(kKinds).find((beginning) => parts[0].startsWith(beginning));
  if (kind) parts[0] = kKinds[kind] + parts[0].slice(kind.length);
  return parts.join('  ');
}

// Calls `listener` now, and whenever another language is chosen.
export function onLanguage(listener) {
  listeners.push(listener);
  listener();
}

function show() {
  document.documentElement.lang = chosen;
  for (const element of document.querySelectorAll('[data-text]')) element.textContent = text(element.dataset.text);
  for (const listener of listeners) listener();
}

export function makeLanguages(button) {
  button.addEventListener('click', () => {
    chosen = chosen === 'en' ? 'ja' : 'en';
    localStorage.setItem(kLanguageKey, chosen);
    show();
  });
  onLanguage(() => {
    button.textContent = text('other');
    button.lang = chosen === 'en' ? 'ja' : 'en';
    button.setAttribute('aria-label', text('otherLabel'));
  });
  show();
}
