// Makes the file that a student hands in, and gives it to the browser to save. For the page of a lab and of a course.

import { fileName, fileText, recordText, signedBytes, studentName } from '../model/progress_file.ts';
import type { LabRecord } from '../model/progress_file.ts';
import { handInTexts } from '../texts_hand_in.ts';
import { browserKey } from './browser_key.ts';
import { download } from './download.ts';

/** The outcome, in words. */
export async function handIn(typed: string, course: string | undefined, labs: readonly LabRecord[]): Promise<string> {
  const student = studentName(typed);
  if (student === null) return handInTexts.noName;
  const key = await browserKey();
  if (typeof key === 'string') return handInTexts.noKey[key];
  const record = recordText({ student, exportedAt: new Date().toISOString(), ...(course === undefined ? {} : { course }), labs });
  const signature = await key.sign(signedBytes(record));
  const name = fileName(student);
  download(name, new Blob([fileText(record, key.publicKey, signature)], { type: 'application/json' }));
  return key.kept ? handInTexts.saved(name) : handInTexts.savedOnce(name);
}
