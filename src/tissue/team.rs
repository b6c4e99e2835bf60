//! Threads that work together, natively. A relaxation event takes some milliseconds and has several parts that
//! must follow each other, so whoever helps stays awake between them: to wake a sleeping thread takes as long
//! as to move some hundred cells.

use std::panic::AssertUnwindSafe;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;

/// How often a helper looks out for the next work before it sleeps: for a fifth of a millisecond or so.
const LOOKS: usize = 8_000;

/// One who calls for work and those who help.
#[derive(Debug)]
pub(super) struct Team {
    shared: Arc<Shared>,
    helpers: Vec<JoinHandle<()>>,
}

#[derive(Debug, Default)]
struct Shared {
    board: Mutex<Board>,
    /// Counts the works that were called out: a helper looks at it without the lock.
    calls: AtomicU64,
    called: Condvar,
}

#[derive(Debug, Default)]
struct Board {
    /// The work under way, which takes a helper's number.
    work: Option<Work>,
    /// How many helpers are at it.
    helping: usize,
    /// Helpers that sleep.
    asleep: usize,
    panicked: bool,
    is_over: bool,
}

/// What helpers are to do; it lives until nobody is at it.
#[derive(Clone, Copy)]
struct Work(*const (dyn Fn(usize) + Sync));

// SAFETY: what it points to may be called by any thread, and `Call` keeps it alive.
unsafe impl Send for Work {}

impl std::fmt::Debug for Work {
    fn fmt(&self, out: &mut std::fmt::Formatter) -> std::fmt::Result {
        out.write_str("Work")
    }
}

impl Team {
    /// So many threads, the one that calls among them.
    ///
    /// # Panics
    /// If the system gives no threads.
    pub(super) fn new(threads: usize) -> Team {
        let shared = Arc::new(Shared::default());
        let helper = |number| {
            let shared = shared.clone();
            std::thread::spawn(move || shared.help(number))
        };
        let helpers = (1..threads).map(helper).collect();
        Team { shared, helpers }
    }

    /// Works off all pieces, each by one thread: `work` takes the thread's number, from 0 up, and the piece.
    ///
    /// # Panics
    /// If some work does.
    pub(super) fn share<T: Send>(&self, pieces: Vec<T>, work: impl Fn(usize, T) + Sync) {
        let pieces = Mutex::new(pieces.into_iter());
        let next = || lock(&pieces).next();
        self.call(&|number| {
            while let Some(piece) = next() {
                work(number, piece);
            }
        });
    }

    /// Has all who come do some work, the caller too, who does not wait for helpers that never came.
    fn call(&self, work: &(dyn Fn(usize) + Sync)) {
        // SAFETY: this is about how long the work lives. `Call` takes it off the board, and waits until nobody
        // is at it, before this returns or unwinds.
        let lasting = unsafe {
            std::mem::transmute::<&(dyn Fn(usize) + Sync), *const (dyn Fn(usize) + Sync)>(work)
        };
        let call = Call(&self.shared);
        let mut board = lock(&self.shared.board);
        board.work = Some(Work(lasting));
        self.shared.calls.fetch_add(1, Ordering::Release);
        if board.asleep > 0 {
            self.shared.called.notify_all();
        }
        drop(board);
        work(0);
        drop(call);
        let panicked = std::mem::take(&mut lock(&self.shared.board).panicked);
        assert!(!panicked, "a helper panicked");
    }
}

impl Drop for Team {
    fn drop(&mut self) {
        lock(&self.shared.board).is_over = true;
        self.shared.calls.fetch_add(1, Ordering::Release);
        self.shared.called.notify_all();
        for helper in self.helpers.drain(..) {
            // It has caught whatever happened.
            let _ = helper.join();
        }
    }
}

/// A work on the board, which must outlive all who are at it.
struct Call<'a>(&'a Shared);

impl Drop for Call<'_> {
    fn drop(&mut self) {
        lock(&self.0.board).work = None;
        // All pieces are given out: the last ones take a moment.
        while lock(&self.0.board).helping > 0 {
            std::hint::spin_loop();
        }
    }
}

impl Shared {
    fn help(&self, number: usize) {
        let mut seen = 0;
        loop {
            self.look_out(seen);
            let mut board = lock(&self.board);
            while self.calls.load(Ordering::Acquire) == seen {
                board.asleep += 1;
                board = self.called.wait(board).unwrap_or_else(PoisonError::into_inner);
                board.asleep -= 1;
            }
            seen = self.calls.load(Ordering::Acquire);
            if board.is_over {
                return;
            }
            let Some(Work(work)) = board.work else { continue };
            board.helping += 1;
            drop(board);
            // SAFETY: it lives while somebody is at it.
            let work = AssertUnwindSafe(|| unsafe { (*work)(number) });
            let done = std::panic::catch_unwind(work);
            let mut board = lock(&self.board);
            board.helping -= 1;
            board.panicked |= done.is_err();
        }
    }

    /// Waits a while for another call than the one that was seen.
    fn look_out(&self, seen: u64) {
        for _ in 0..LOOKS {
            if self.calls.load(Ordering::Acquire) != seen {
                return;
            }
            std::hint::spin_loop();
        }
    }
}

/// What a panic left behind is no worse: nothing is kept between two pieces.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::AtomicUsize;

    #[test]
    fn every_piece_is_worked_off_once_by_a_member_however_many_are_called_for() {
        for threads in [1, 2, 5] {
            let team = Team::new(threads);
            for pieces in [0, 1, 3, 100] {
                for _ in 0..50 {
                    let mut done = vec![0; pieces];
                    team.share(done.iter_mut().collect(), |number, piece| {
                        assert!(number < threads);
                        *piece += 1;
                    });
                    assert_eq!(done, vec![1; pieces]);
                }
            }
        }
    }

    #[test]
    fn helpers_that_sleep_come_when_they_are_called() {
        let team = Team::new(2);
        std::thread::sleep(std::time::Duration::from_millis(50));
        // Each piece waits for the other one: one thread alone would wait for ever.
        let begun = AtomicUsize::new(0);
        team.share(vec![(), ()], |_, ()| {
            begun.fetch_add(1, Ordering::SeqCst);
            while begun.load(Ordering::SeqCst) < 2 {
                std::thread::yield_now();
            }
        });
    }

    #[test]
    fn a_panic_of_anyone_reaches_the_caller_and_the_team_works_on() {
        let team = Team::new(2);
        for who in [0, 1] {
            let begun = AtomicUsize::new(0);
            let panics = AssertUnwindSafe(|| {
                team.share(vec![(), ()], |number, ()| {
                    begun.fetch_add(1, Ordering::SeqCst);
                    while begun.load(Ordering::SeqCst) < 2 {
                        std::thread::yield_now();
                    }
                    assert!(number != who, "meant to");
                });
            });
            assert!(std::panic::catch_unwind(panics).is_err());
        }
        let sum = AtomicUsize::new(0);
        team.share((1..=10).collect(), |_, piece: usize| {
            sum.fetch_add(piece, Ordering::SeqCst);
        });
        assert_eq!(sum.into_inner(), 55);
    }
}
