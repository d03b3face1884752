// Pairing: the six digits on the box's screen authorise this browser.
import {onLanguage, text} from './texts.js';
import {meet} from './wire.js';

const $ = (id) => document.getElementById(id);
let wrong = null;  // The key of the text that says what was wrong.

function show() {
  $('wrong').textContent = wrong ? text(wrong) : '';
  $('code').setAttribute('aria-label', text('code'));
}

async function pair(event) {
  event.preventDefault();
  wrong = null;
  try {
    const reply = await fetch('/pair', {method: 'POST', body: $('code').value});
    if (reply.ok) {
      await meet();
    } else {
      wrong = reply.status === 429 ? 'wait' : 'wrongCode';
    }
  } catch {
    wrong = 'lost';
  }
  $('code').value = '';
  show();
}

export function askForCode() {
  document.body.dataset.view = 'pair';
  $('code').focus();
}

export function makePairing() {
  $('pair').addEventListener('submit', pair);
  $('code').addEventListener('input', () => {
    $('code').value = $('code').value.replace(/[^0-9]/g, '');
  });
  onLanguage(show);
}
