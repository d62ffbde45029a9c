// The page of a course: beside each lab what this browser keeps of its tasks, and a file of all of it to hand in. Runs as a
// classic script below the list. The list says which tasks each lab has; what is done comes from the labs' pages
// (parts/task_desk.ts).

import { browserStore, readText } from './model/preferences.ts';
import { progressName, readProgress } from './model/progress.ts';
import type { Progress } from './model/progress.ts';
import { MOST_NAME } from './model/progress_file.ts';
import { handIn } from './parts/hand_in.ts';
import { courseTexts } from './texts_course.ts';
import { handInTexts } from './texts_hand_in.ts';

interface Lab {
  readonly item: HTMLElement;
  readonly title: string;
  readonly sha256: string;
  /** Each task, done or not. */
  readonly tasks: Progress;
}

/** The titles that `pack` wrote there. */
function titlesOf(item: HTMLElement): readonly string[] {
  const titles: unknown = JSON.parse(item.dataset['tasks'] ?? '[]');
  return Array.isArray(titles) ? titles.filter((title): title is string => typeof title === 'string') : [];
}

function labs(): readonly Lab[] {
  const store = browserStore();
  return [...document.querySelectorAll<HTMLElement>('li[data-lab]')].map((item) => {
    const place = new URL(`${item.dataset['lab'] ?? ''}/`, document.baseURI).pathname;
    const kept = new Map(readProgress(readText(store, progressName(place))).map((task) => [task.title, task]));
    return {
      item,
      title: item.querySelector('a')?.textContent ?? '',
      sha256: item.dataset['sha256'] ?? '',
      tasks: titlesOf(item).map((title) => kept.get(title) ?? { title, seen: [] }),
    };
  });
}

function doneOf({ tasks }: Lab): number {
  return tasks.filter(({ doneAt }) => doneAt !== undefined).length;
}

/** The one line about progress among the children of `parent`, made when it is not there. */
function progressLine(parent: Element, before: Element | null): HTMLElement {
  const known = [...parent.children].find((one): one is HTMLElement => one instanceof HTMLElement && one.className === 'progress');
  if (known !== undefined) return known;
  const made = document.createElement('p');
  made.className = 'progress';
  parent.insertBefore(made, before);
  return made;
}

function show(): void {
  const all = labs();
  for (const lab of all) {
    const [done, count] = [doneOf(lab), lab.tasks.length];
    progressLine(lab.item, null).textContent = done === count ? courseTexts.labDone(count) : courseTexts.doneOf(done, count);
    lab.item.classList.toggle('done', done === count);
  }
  const list = document.querySelector('ol');
  if (list?.parentElement == null) return;
  const sum = (numbers: readonly number[]): number => numbers.reduce((before, number) => before + number, 0);
  progressLine(list.parentElement, list).textContent = courseTexts.course(sum(all.map(doneOf)), sum(all.map(({ tasks }) => tasks.length)));
}

function addForm(): void {
  const form = document.createElement('form');
  form.className = 'hand-in';
  const label = document.createElement('label');
  const input = document.createElement('input');
  const button = document.createElement('button');
  const said = document.createElement('p');
  input.autocomplete = 'name';
  input.maxLength = MOST_NAME;
  label.append(handInTexts.name, input);
  button.textContent = handInTexts.save;
  said.setAttribute('role', 'status');
  said.textContent = handInTexts.about;
  form.append(label, button, said);
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const course = document.querySelector('h1')?.textContent ?? '';
    handIn(input.value, course, labs()).then(
      (words) => {
        said.textContent = words;
      },
      (error: unknown) => {
        said.textContent = String(error);
      },
    );
  });
  document.querySelector('main')?.append(form);
}

show();
addForm();
// Back from a lab, and a lab in another tab.
addEventListener('pageshow', show);
addEventListener('storage', show);
