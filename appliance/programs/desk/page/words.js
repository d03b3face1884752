// What the page says, in English and Japanese; the box's own complaints too.

const kWords = {
  en: {
    title: 'Lips',
    other: '日本語',
    otherLabel: 'Read this page in Japanese',
    pairTitle: 'Pair with the box',
    pairText: 'Type the six digits that stand on the box\'s own screen.',
    code: 'The six digits',
    pair: 'Pair',
    wrongCode: 'This is not the code on the screen.',
    wait: 'Five wrong codes. Wait a minute, then look at the screen again.',
    live: 'live',
    lost: 'The desk does not answer',
    noLips: 'The lips do not answer',
    noCamera: 'No camera',
    stale: 'The camera is silent',
    waiting: 'one moment',
    pictureLabel: 'What the lip camera sees. Tap the paint to sample it.',
    views: 'How the picture is shown',
    viewPlain: 'Picture',
    viewBoth: 'Paint',
    viewMask: 'Mask',
    tap: 'Tap the paint on the lips.',
    find: 'Find it',
    paintLabel: 'The paint',
    taken: 'Paint taken',
    found: 'Paint found',
    mouth: 'Mouth',
    mouthLabel: 'The mouth as it is measured',
    opened: 'open',
    wide: 'wide',
    height: 'height',
    width: 'width',
    quality: 'quality',
    age: 'age',
    steps: 'Teach the mouth',
    stepsText: 'Hold each for a second; or just speak.',
    shut: 'Shut',
    open: 'Open',
    wideStep: 'Wide',
    narrow: 'Narrow',
    speak: 'Speak for ten seconds',
    hold: 'hold …',
    speaking: 'speak …',
    noMouth: 'no mouth is seen',
    doneStep: 'taken',
    stop: 'Stop',
    tuning: 'Fine tuning',
    similarity: 'Similarity',
    similarityText: 'More takes more colours for paint.',
    smoothness: 'Smoothness',
    smoothnessText: 'How soft the paint\'s edge is.',
    spill: 'Spill',
    spillText: 'More leaves out the paint\'s light on skin and teeth.',
    still: 'Stillness, Hz',
    stillText: 'Cut-off of a mouth at rest: lower is stiller.',
    quick: 'Quickness',
    quickText: 'Cut-off gained with speed: higher follows sooner.',
    gate: 'Voice from, dB',
    gateText: 'What is louder is a voice.',
    delay: 'Sound delay, ms',
    delayText: '-1: as long as the picture takes.',
    light: 'to the light',
    freeLight: 'Adjust light',
    holdLight: 'Hold light',
    freed: 'The camera finds its light',
    held: 'The camera is held',
    undo: 'Undo',
    revert: 'Go back …',
    saved: 'To what is saved',
    before: 'To the one saved before',
    defaults: 'To a new box',
    leave: 'Leave the desk',
    save: 'Save',
    savedNow: 'Saved',
    reverted: 'Back',
    gone: 'The lips are gone',
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
    taken: '色を取りました',
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
    light: '光まで',
    freeLight: '明るさを合わせる',
    holdLight: '明るさを固定',
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
  },
};

// What the box may answer.
const kComplaints = {
  'sample the paint: this is grey': 'ここは灰色です',
  'sample the paint: these are several colours': 'ここには色がいくつもあります',
  'sample the paint: the click is outside the picture': '映像の外です',
  'no paint is seen': '塗料が見つかりません',
  'no picture comes from the camera': 'カメラから映像が来ません',
  'there is nothing to take back': '戻すものがありません',
  'nothing was kept': '保存したものがありません',
  'it is being saved': '保存しています',
  'there is no file to keep it in': '保存する場所がありません',
  'mouth.shut is not below mouth.open': 'とじた口があけた口より大きくなっています',
};

const kKept = 'kaori-desk-language';
const listeners = [];
let language = localStorage.getItem(kKept) ?? document.documentElement.lang;
if (!(language in kWords)) language = 'en';

export function word(key) {
  return kWords[language][key];
}

export function complaint(text) {
  if (language === 'ja' && text in kComplaints) return kComplaints[text];
  const short = text.replace('sample the paint: ', '');
  return short.charAt(0).toUpperCase() + short.slice(1);
}

// Called at once, and whenever another language is chosen.
export function onLanguage(listener) {
  listeners.push(listener);
  listener();
}

function show() {
  document.documentElement.lang = language;
  for (const element of document.querySelectorAll('[data-word]')) element.textContent = word(element.dataset.word);
  for (const listener of listeners) listener();
}

export function makeLanguages(button) {
  button.addEventListener('click', () => {
    language = language === 'en' ? 'ja' : 'en';
    localStorage.setItem(kKept, language);
    show();
  });
  onLanguage(() => {
    button.textContent = word('other');
    button.lang = language === 'en' ? 'ja' : 'en';
    button.setAttribute('aria-label', word('otherLabel'));
  });
  show();
}
